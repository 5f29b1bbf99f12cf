#include "core/surface/surface.h"

#include "core/base/beside.h"
#include "core/base/overload.h"
#include "core/mesh/mesh_file.h"
#include "core/surface/formula_note.h"
#include "core/surface/shapes.h"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace normalscope {

namespace {

constexpr std::size_t kTrianglesWorthAThread = 50'000;
constexpr int kFormulaCells = 40;  // a side: some thousand vertices for arrows to stand on

// Leaves those that are as near to f = 0 as rounding lets them come: all but vertices beside a double point.
void keep_on_surface(const ImplicitSurface& surface, std::vector<Site>& sites) {
    std::vector<glm::dvec3> points;
    for (const Site& site : sites) points.push_back(site.point.xyz);
    std::vector<formulas::Sample> samples(points.size());
    formulas::samples(surface.program(), points, samples);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (std::abs(samples[i].value) <= 1e-9 * glm::length(samples[i].gradient) * surface.source().bound)
            sites[kept++] = sites[i];
    sites.resize(kept);
}

}  // namespace

std::shared_ptr<const Surface> SurfaceCache::get(const Scene& scene, const Stop& stop) {
    const bool same_mesh = has_mesh_of(scene);
    // Which arrow kinds are shown and how long they are does not change where they stand.
    const auto placement = [](const Arrows& a) { return std::tuple(a.at, a.every, a.limit); };
    if (surface_ && surface_source_ == scene.surface && placement(surface_arrows_) == placement(scene.arrows))
        return surface_;

    // The faces of a formula's mesh are not the surface: its arrows stand on the surface's own points.
    const bool faces =
        scene.arrows.at == ArrowPlacement::Faces && !std::holds_alternative<FormulaSurface>(scene.surface);
    auto surface = std::make_shared<Surface>();
    if (!same_mesh) {
        std::shared_ptr<ImplicitSurface> implicit;
        surface->mesh = std::visit(Overload{[](const ShapeSurface& shape) { return make_shape(shape); },
                                            [](const MeshSurface& file) { return load_mesh(file.mesh); },
                                            [&](const FormulaSurface& formula) {
                                                implicit = std::make_shared<ImplicitSurface>(formula);
                                                Mesh mesh = polygonised(*implicit, kFormulaCells, stop);
                                                implicit->check_floats(mesh);
                                                FormulaNote note = note_on(*implicit, mesh, stop);
                                                if (!note.text.empty()) mesh.notes.push_back(std::move(note.text));
                                                if (!note.drawn) implicit->hide();
                                                return mesh;
                                            }},
                                   scene.surface);
        implicit_ = std::move(implicit);
        // A mesh that is drawn as it is need not be kept twice: it takes time and memory to copy a million triangles.
        mesh_ = faces ? std::make_shared<const Mesh>(std::move(surface->mesh))
                      : std::shared_ptr<const Mesh>(surface, &surface->mesh);
        mesh_source_ = scene.surface;
        tree_ = std::make_shared<TreeInTime>();
    }
    surface->tree = tree_;  // flat shading changes no triangle's place
    surface->implicit = implicit_;
    const Begin begin = mesh_->triangles.size() < kTrianglesWorthAThread ? Begin::WhenAsked : Begin::AtOnce;
    Beside<double> area = beside([mesh = mesh_] { return surface_area(*mesh); }, begin);
    for (const glm::dvec3& p : mesh_->positions) surface->extent = glm::max(surface->extent, glm::abs(p));
    std::vector<Site> sites = faces ? face_sites(*mesh_) : vertex_sites(*mesh_);
    if (implicit_) keep_on_surface(*implicit_, sites);
    surface->area = area.get();
    surface->arrows = thinned(std::move(sites), static_cast<std::size_t>(scene.arrows.every),
                              static_cast<std::size_t>(scene.arrows.limit), surface->area);
    if (faces)
        surface->mesh = flat_shaded(*mesh_);
    else if (same_mesh)
        surface->mesh = *mesh_;
    surface_ = std::move(surface);
    surface_source_ = scene.surface;
    surface_arrows_ = scene.arrows;
    return surface_;
}

Mesh flat_shaded(const Mesh& mesh) {
    std::vector<glm::dvec3> face_normals(mesh.face_count(), glm::dvec3(0.0));
    const auto face_of = [&](std::size_t triangle) {
        return mesh.face_of_triangle.empty() ? triangle : mesh.face_of_triangle[triangle];
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::dvec3& a = mesh.positions[t.x];
        face_normals[face_of(i)] += glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
    }
    Mesh flat;
    flat.face_of_triangle = mesh.face_of_triangle;
    flat.closed = mesh.closed;
    flat.normal_source = mesh.normal_source;
    flat.notes = mesh.notes;
    flat.positions.reserve(3 * mesh.triangles.size());
    flat.normals.reserve(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::dvec3& sum = face_normals[face_of(i)];
        const double length = glm::length(sum);
        const auto first = static_cast<std::uint32_t>(flat.positions.size());
        for (int k = 0; k < 3; ++k) {
            flat.positions.push_back(mesh.positions[mesh.triangles[i][k]]);
            flat.normals.push_back(length > 0.0 ? sum / length : glm::dvec3(0.0));
        }
        flat.triangles.push_back({first, first + 1, first + 2});
    }
    return flat;
}

std::optional<double> error_degrees(const NormalMatrices& matrices, Normal<Object> n) {
    if (!matrices.inverse_transpose) return std::nullopt;
    return angle_degrees(matrices.naive * n.xyz, *matrices.inverse_transpose * n.xyz);
}

namespace {

// Of equally bad ones the first is named: a rounding, which differs from library to library, must not choose.
constexpr double kEqualRadians = 1e-12, kEqualDegrees = 1e-10;

// Rounding must not make it more than the worst, nor may what has normals but no area leave none.
double mean_of(double sum, double area, double worst) { return area > 0.0 ? std::min(sum / area, worst) : worst; }

// Of a 3×3 matrix, where M is affine and has an inverse.
std::optional<ErrorStatistics> linear_error_statistics(const Mesh& mesh, const glm::dmat3& shown,
                                                       const NormalMatrices& matrices) {
    const glm::dmat3& inverse_transpose = *matrices.inverse_transpose;
    const bool naive = shown == matrices.naive;
    const std::vector<double> areas = vertex_areas(mesh);
    double sum = 0.0, area = 0.0, worst_angle = -1.0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const glm::dvec3& n = mesh.normals[i];
        if (n == glm::dvec3(0.0)) continue;
        // The angle between the two images by their cross and their dot product, which is n·n for the naive rule.
        const glm::dvec3 a = shown * n, b = inverse_transpose * n, cross = glm::cross(a, b);
        const double sine = glm::length(cross), cosine = naive ? glm::dot(n, n) : glm::dot(a, b);
        if (sine == 0.0 && cosine == 0.0) continue;
        const double angle = std::atan2(sine, cosine);
        sum += areas[i] * angle;
        area += areas[i];
        if (angle > worst_angle + kEqualRadians) {
            worst_angle = angle;
            worst = i;
        }
    }
    if (worst_angle < 0.0) return std::nullopt;
    ErrorStatistics statistics;
    statistics.worst_degrees =
        angle_degrees(shown * mesh.normals[worst], inverse_transpose * mesh.normals[worst]).value_or(0.0);
    statistics.mean_degrees = mean_of(glm::degrees(sum), area, statistics.worst_degrees);
    statistics.at = {mesh.positions[worst]};
    return statistics;
}

}  // namespace

std::optional<ErrorStatistics> error_statistics(const Mesh& mesh, const NormalMatrices& matrices) {
    if (!matrices.inverse_transpose) return std::nullopt;
    return linear_error_statistics(mesh, matrices.naive, matrices);
}

std::optional<ErrorStatistics> error_statistics(const Mesh& mesh, const NormalMap& naive,
                                                const Transform<World, Object>& world_from_object) {
    const NormalMatrices& matrices = world_from_object.normal_matrices_by_rule();
    if (world_from_object.affine() && matrices.inverse_transpose && naive.w == 0.0)
        return linear_error_statistics(mesh, glm::dmat3(naive.matrix), matrices);
    ErrorStatistics statistics;
    const std::vector<double> areas = vertex_areas(mesh);
    double sum = 0.0, area = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Normal<Object> n{mesh.normals[i]};
        const auto right = world_from_object(Point<Object>{mesh.positions[i]}, n);
        const auto error = right ? angle_degrees(naive(n).xyz, right->xyz) : std::nullopt;
        if (!error) continue;
        sum += areas[i] * *error;
        area += areas[i];
        if (count++ == 0 || *error > statistics.worst_degrees + kEqualDegrees) {
            statistics.worst_degrees = *error;
            statistics.at = {mesh.positions[i]};
        }
    }
    if (count == 0) return std::nullopt;
    statistics.mean_degrees = mean_of(sum, area, statistics.worst_degrees);
    return statistics;
}

}  // namespace normalscope

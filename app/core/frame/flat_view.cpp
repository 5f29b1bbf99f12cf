#include "core/frame/flat_view.h"

#include "core/scene/mistakes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace normalscope {

namespace {

constexpr double kNothing = 1e-9;
constexpr double kSeen = 0.02;  // of a vector's length: what leaves the plane by less is not worth a word

std::optional<glm::dvec2> part_of(const FlatPlane& plane, const glm::dvec3& v, double per) {
    const glm::dvec2 part = plane.part(v);
    if (!(glm::length(part) > kNothing * glm::length(v))) return std::nullopt;
    return part / per;
}

bool leaves(const FlatPlane& plane, const glm::dvec3& v) {
    return std::abs(glm::dot(plane.normal, v)) > kSeen * glm::length(v);
}

// A rule that is diagonal in x and y, and for which z is nothing to them.
std::optional<glm::dvec2> factors_of(const NormalMap& map, const FlatPlane& plane) {
    const auto image = [&](const glm::dvec3& n) { return plane.part(map(Normal<Object>{n}).xyz); };
    const glm::dvec2 zero = image({}), x = image({1.0, 0.0, 0.0}), y = image({0.0, 1.0, 0.0}),
                     z = image({0.0, 0.0, 1.0});
    const double small = kNothing * std::max(glm::length(x), glm::length(y));
    if (glm::length(zero) > small || std::abs(x.y) > small || std::abs(y.x) > small || glm::length(z) > small)
        return std::nullopt;
    return glm::dvec2(x.x, y.y);
}

std::string note_on(const FlatView& view, const std::optional<ProbeInWorld>& probe) {
    const bool misses_a_sheet = view.cut->misses_a_sheet;
    if (view.cut->curves.empty() && misses_a_sheet)
        return "The surface lies in the plane z = 0: there is no curve to draw.";
    if (view.cut->curves.empty()) return "The surface does not cross the plane z = 0: there is no curve to draw.";
    if (view.plane.image == FlatPlane::Image::Point) return "M sends this plane to a single point: no curve is left.";
    if (view.plane.image == FlatPlane::Image::Line) return "M flattens this plane to a line, and the curve with it.";
    if (probe && !probe->object.has_normal())
        return "\u2207f is zero or does not exist at the probe: there is no normal.";
    if (probe && !view.n_object) return "The normal is perpendicular to this plane at the probe.";
    if (probe && !view.truth) return "M flattens the object into this plane: its normal points straight at you.";
    bool leaving = probe && leaves({}, probe->object.normal.xyz);
    if (probe)
        for (const Rule rule : kRules) {
            const auto& n = probe->normals[rule];
            leaving = leaving || (n && leaves(view.plane, n->xyz));
        }
    if (misses_a_sheet)
        return "Part of the surface lies in the plane z = 0; the curves show where the rest crosses it.";
    if (leaving) return "The normals leave this plane at the probe: their parts within it are drawn.";
    if (view.plane.tilted) return "M tilts the plane: both curves are seen straight on, each in its own.";
    return {};
}

}  // namespace

FlatView flat_view(std::shared_ptr<const FlatCut> cut, const Transform<World, Object>& world_from_object) {
    FlatView view;
    view.cut = std::move(cut);
    view.plane = flat_plane(world_from_object);
    return view;
}

void judge(FlatView& view, const Scene& scene, const std::optional<ProbeInWorld>& probe,
           const Transform<World, Object>& m, double right_power) {
    if (probe && probe->object.has_normal()) {
        const glm::dvec3 n = probe->object.normal.xyz, along(-n.y, n.x, 0.0);
        const double length = glm::length(along);
        if (length > 1e-6) {
            view.n_object = glm::dvec2(n) / length;
            for (const Rule rule : kRules)
                if (const auto& image = probe->normals[rule])
                    view.normals[rule] = part_of(view.plane, image->xyz, length);
            if (probe->truth) view.truth = part_of(view.plane, probe->truth->xyz, length);
            const auto mistaken = mistaken_tangents(scene, m);
            const glm::dvec3 t = mistaken ? *mistaken * along : m(probe->object.point, Vector<Object>{along}).xyz;
            view.tangent = part_of(view.plane, t, length);
        }
    }
    if (const auto &naive = view.normals[Rule::Naive], &truth = view.truth; naive && truth)
        view.error_degrees = angle_degrees({*naive, 0.0}, {*truth, 0.0});
    for (const Rule rule : kRules)
        if (const auto map = normal_map(scene, m, rule, right_power); map && m.affine() && !view.plane.tilted)
            view.factors[rule] = factors_of(*map, view.plane);
    view.note = note_on(view, probe);
}

std::optional<Point<Object>> point_on_cut(const FlatView& view, const Transform<World, Object>& m,
                                          const CameraView& camera, glm::dvec2 pixel, double reach) {
    std::optional<Point<Object>> found;
    double nearest = reach;
    for (const Curve& curve : view.cut->curves)
        for (const CurvePiece& piece : curve.pieces) {
            const Point<Object>&from = piece.from.point, &to = piece.to.point;
            if (!m.reaches(from) || !m.reaches(to)) continue;
            const glm::dvec2 a(camera.pixel(m(from))), ab = glm::dvec2(camera.pixel(m(to))) - a;
            const double along = glm::clamp(glm::dot(pixel - a, ab) / std::max(glm::dot(ab, ab), 1e-12), 0.0, 1.0);
            const double distance = glm::distance(pixel, a + along * ab);
            if (distance > nearest) continue;
            nearest = distance;
            found = Point<Object>{glm::mix(from.xyz, to.xyz, along)};
        }
    return found;
}

}  // namespace normalscope

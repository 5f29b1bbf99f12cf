#include "core/surface/flat_cut.h"

#include "core/surface/level_sets.h"
#include "core/surface/surface_probe.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

bool has_triangle_in_plane(const Mesh& mesh) {
    return std::ranges::any_of(mesh.triangles, [&](const glm::uvec3& t) {
        const auto in_plane = [&](std::uint32_t i) { return mesh.positions[i].z == 0.0; };
        return in_plane(t.x) && in_plane(t.y) && in_plane(t.z);
    });
}

// A corner in the plane counts as above it, so that each triangle which the plane parts is met along one piece, and one that
// lies in the plane along none.
std::vector<CurvePiece> pieces_of_mesh(const Mesh& mesh) {
    const auto above = [&](std::uint32_t i) { return mesh.positions[i].z >= 0.0; };
    // The same for an edge from either side, to the last bit.
    const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
        if (!above(a)) std::swap(a, b);
        const glm::dvec3 &p = mesh.positions[a], &q = mesh.positions[b];
        const double s = p.z / (p.z - q.z);
        glm::dvec3 at = glm::mix(p, q, s);
        at.z = 0.0;
        return Site{{at}, {glm::mix(mesh.normals[a], mesh.normals[b], s)}};
    };
    std::vector<CurvePiece> pieces;
    for (const glm::uvec3& t : mesh.triangles)
        for (glm::length_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
            if (above(a) == above(b) || above(a) == above(c)) continue;
            CurvePiece piece{crossing(a, b), crossing(a, c)};  // a is alone on its side
            for (Site* site : {&piece.from, &piece.to})
                if (glm::length(site->normal.xyz) < 1e-9)
                    site->normal = {
                        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])};
            pieces.push_back(piece);
        }
    return pieces;
}

// Where f is level, as max(z, x² + y² - 1) is below its lid, nothing leads to the curve: the nearest change of sign around.
glm::dvec3 onto_edge(const ImplicitSurface& surface, const glm::dvec3& start, double reach) {
    constexpr int kWays = 16, kHalvings = 40;
    const bool below = surface.at({start}).value < 0.0;
    glm::dvec3 best = start;
    double nearest = reach;
    for (int way = 0; way < kWays; ++way) {
        const double angle = glm::two_pi<double>() * way / kWays;
        const glm::dvec3 along(std::cos(angle), std::sin(angle), 0.0);
        const auto crosses = [&](double distance) {
            return (surface.at({start + distance * along}).value < 0.0) != below;
        };
        double near = 0.0, far = nearest;
        if (!crosses(far)) continue;
        for (int i = 0; i < kHalvings; ++i) (crosses(0.5 * (near + far)) ? far : near) = 0.5 * (near + far);
        nearest = far;
        best = start + far * along;
    }
    return best;
}

// Newton's steps within the plane; where they lead away, the point stays.
glm::dvec3 onto_curve(const ImplicitSurface& surface, const glm::dvec3& start, double reach) {
    glm::dvec3 p = start;
    for (int i = 0; i < 8; ++i) {
        const formulas::Sample s = surface.at({p});
        const glm::dvec3 slope(s.gradient.x, s.gradient.y, 0.0);
        if (slope == glm::dvec3(0.0) && s.value != 0.0) return onto_edge(surface, start, 3.0 * reach);
        const glm::dvec3 next = p - s.value / glm::dot(slope, slope) * slope;
        if (!(glm::distance(next, start) <= reach)) return p == start ? start : p;
        if (next == p) break;
        p = next;
    }
    return p;
}

// Where f changes its sign on the plane z = height, brought back to z = 0.
std::vector<CurvePiece> pieces_at(const ImplicitSurface& surface, double height) {
    const LevelSets sets = level_sets(surface, {Axis::Z, height, false}, Detail::Lines);
    const double reach = 0.01 * sets.reach;
    std::vector<CurvePiece> pieces;
    for (const LevelSets::Line& line : sets.lines) {
        if (line.level != 0) continue;
        const auto site = [&](const glm::dvec3& end) {
            const glm::dvec3 p = onto_curve(surface, end, reach);
            return Site{{{p.x, p.y, 0.0}}, {surface.at({p}).gradient}};
        };
        pieces.push_back({site(line.ends[0]), site(line.ends[1])});
    }
    return pieces;
}

// Whether f is 0 on more than curves of the plane, as z (x² + y² + z² - 1) is.
bool contains_plane(const ImplicitSurface& surface) {
    const formulas::Box& region = *surface.region();
    constexpr int kSide = 24;
    constexpr double kBeside = 0.317;  // of a square: a curve along the axes runs between the points
    constexpr int kOfACurve = 2 * kSide;
    int zeros = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::dvec2 share = (glm::dvec2(i % kSide, i / kSide) + kBeside) / double{kSide};
        zeros += surface.lies_on(glm::dvec3(glm::mix(glm::dvec2(region.low), glm::dvec2(region.high), share), 0.0));
    }
    return zeros > kOfACurve;
}

// What lies in the plane has no curve; what else crosses it there does so just below it, or just above.
std::vector<CurvePiece> pieces_beside_plane(const ImplicitSurface& surface) {
    const double beside = 1e-7 * surface.source().bound;
    std::vector<CurvePiece> below = pieces_at(surface, -beside);
    return below.empty() ? pieces_at(surface, beside) : below;
}

// The plane in bands across y, between the heights of the corners: within a band no two sides meet.
std::vector<std::array<glm::dvec2, 4>> inside_of(const std::vector<Curve>& curves) {
    using Side = std::array<glm::dvec2, 2>;  // going up
    std::vector<Side> sides;
    std::vector<double> heights;
    for (const Curve& curve : curves)
        for (const CurvePiece& piece : curve.closed ? curve.pieces : std::vector<CurvePiece>{}) {
            glm::dvec2 a(piece.from.point.xyz), b(piece.to.point.xyz);
            if (a.y == b.y) continue;
            if (a.y > b.y) std::swap(a, b);
            sides.push_back({a, b});
            heights.push_back(a.y), heights.push_back(b.y);
        }
    std::ranges::sort(heights);
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    std::ranges::sort(sides, {}, [](const Side& side) { return side[0].y; });

    std::vector<std::array<glm::dvec2, 4>> result;
    std::vector<Side> met;
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const double low = heights[i], high = heights[i + 1], middle = 0.5 * (low + high);
        std::erase_if(met, [&](const Side& side) { return side[1].y <= low; });
        for (; next < sides.size() && sides[next][0].y <= low; ++next) met.push_back(sides[next]);
        const auto at = [](const Side& side, double y) {
            return glm::dvec2(glm::mix(side[0].x, side[1].x, (y - side[0].y) / (side[1].y - side[0].y)), y);
        };
        std::ranges::sort(met, {}, [&](const Side& side) { return at(side, middle).x; });
        for (std::size_t k = 0; k + 1 < met.size(); k += 2)
            result.push_back({at(met[k], low), at(met[k + 1], low), at(met[k + 1], high), at(met[k], high)});
    }
    return result;
}

struct Nearest {
    const CurvePiece* piece = nullptr;
    double along = 0.0;
    double distance = std::numeric_limits<double>::infinity();
};
Nearest nearest_piece(const FlatCut& cut, const glm::dvec2& p) {
    Nearest best;
    for (const Curve& curve : cut.curves)
        for (const CurvePiece& piece : curve.pieces) {
            const glm::dvec2 a(piece.from.point.xyz), ab = glm::dvec2(piece.to.point.xyz) - a;
            const double s = glm::clamp(glm::dot(p - a, ab) / std::max(glm::dot(ab, ab), 1e-300), 0.0, 1.0);
            const double distance = glm::distance(p, a + s * ab);
            if (distance < best.distance) best = {&piece, s, distance};
        }
    return best;
}

Site between(const CurvePiece& piece, double s) {
    return {{glm::mix(piece.from.point.xyz, piece.to.point.xyz, s)},
            {glm::mix(piece.from.normal.xyz, piece.to.normal.xyz, s)}};
}

}  // namespace

FlatCut flat_cut(const Surface& surface) {
    FlatCut cut;
    std::vector<CurvePiece> pieces;
    if (surface.implicit && surface.implicit->region()) {
        cut.misses_a_sheet = contains_plane(*surface.implicit);
        pieces = cut.misses_a_sheet ? pieces_beside_plane(*surface.implicit) : pieces_at(*surface.implicit, 0.0);
        if (pieces.empty() && !cut.misses_a_sheet) pieces = pieces_of_mesh(surface.mesh);
    } else {
        cut.misses_a_sheet = has_triangle_in_plane(surface.mesh);
        pieces = pieces_of_mesh(surface.mesh);
    }
    double extent = 0.0;
    for (const CurvePiece& piece : pieces) {
        extent = std::max({extent, glm::length(piece.from.point.xyz), glm::length(piece.to.point.xyz)});
        cut.length += glm::distance(piece.from.point.xyz, piece.to.point.xyz);
    }
    cut.curves = joined(pieces, 1e-6 * extent);
    cut.inside = inside_of(cut.curves);
    return cut;
}

std::optional<Probe> nearest_on_cut(const Surface& surface, const FlatCut& cut, Point<Object> p,
                                    const std::optional<Direction<Object>>& borrow) {
    const Nearest nearest = nearest_piece(cut, glm::dvec2(p.xyz));
    if (!nearest.piece) return std::nullopt;
    const Site site = between(*nearest.piece, nearest.along);
    if (!surface.implicit) return probe_with(site.point, site.normal);
    // What is meant to be singular, such as a crossing, is so to the last bit.
    if (p.xyz.z == 0.0 && nearest.distance < 1e-9 && surface.implicit->lies_on(p.xyz))
        return probe_on(*surface.implicit, p, borrow);
    const double reach = 0.01 * surface.implicit->source().bound;
    return probe_on(*surface.implicit, {onto_curve(*surface.implicit, site.point.xyz, reach)}, borrow);
}

std::optional<Probe> usual_on_cut(const Surface& surface, const FlatCut& cut) {
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const Curve& curve : cut.curves)
        for (const CurvePiece& piece : curve.pieces)
            for (const Site* site : {&piece.from, &piece.to}) {
                low = glm::min(low, glm::dvec2(site->point.xyz));
                high = glm::max(high, glm::dvec2(site->point.xyz));
            }
    if (!(low.x <= high.x)) return std::nullopt;
    const glm::dvec2 middle = 0.5 * (low + high), way(0.8, 0.6), across(-way.y, way.x);
    double farthest = 0.0;
    for (const Curve& curve : cut.curves)
        for (const CurvePiece& piece : curve.pieces) {
            const glm::dvec2 a = glm::dvec2(piece.from.point.xyz) - middle, b = glm::dvec2(piece.to.point.xyz) - middle;
            const double sa = glm::dot(a, across), sb = glm::dot(b, across);
            if ((sa < 0.0) == (sb < 0.0)) continue;
            farthest = std::max(farthest, glm::dot(glm::mix(a, b, sa / (sa - sb)), way));
        }
    if (!(farthest > 0.0)) farthest = glm::distance(low, high);
    return nearest_on_cut(surface, cut, {glm::dvec3(middle + farthest * way, 0.0)});
}

std::vector<Site> sites_along(const FlatCut& cut, double spacing) {
    std::vector<Site> sites;
    for (const Curve& curve : cut.curves) {
        double whole = 0.0;
        for (const CurvePiece& piece : curve.pieces) whole += glm::distance(piece.from.point.xyz, piece.to.point.xyz);
        const double count = std::max(1.0, std::round(whole / spacing)), step = whole / count;
        // The first is half a step in: an open curve's ends are no places for arrows.
        double wanted = 0.5 * step, passed = 0.0;
        for (const CurvePiece& piece : curve.pieces) {
            const double length = glm::distance(piece.from.point.xyz, piece.to.point.xyz);
            for (; wanted <= passed + length && wanted < whole && length > 0.0; wanted += step) {
                const Site site = between(piece, (wanted - passed) / length);
                if (const double n = glm::length(site.normal.xyz); n > 0.0)
                    sites.push_back({site.point, {site.normal.xyz / n}});
            }
            passed += length;
        }
    }
    return sites;
}

std::shared_ptr<const FlatCut> FlatCutCache::get(const Scene& scene, const std::shared_ptr<const Surface>& surface) {
    if (scene.view != ViewMode::Flat) return nullptr;
    if (!cut_ || surface_ != surface) {
        surface_ = surface;
        cut_ = std::make_shared<const FlatCut>(flat_cut(*surface));
    }
    return cut_;
}

}  // namespace normalscope

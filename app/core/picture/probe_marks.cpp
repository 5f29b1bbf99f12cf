#include "core/picture/probe_marks.h"

#include "core/picture/arcs.h"
#include "core/picture/frame_options.h"
#include "core/picture/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace normalscope {

namespace {

// The plane that the world tangents span; empty where M has collapsed it.
struct TangentPlane {
    glm::dvec3 centre, normal, u, v;  // orthonormal
};
std::optional<TangentPlane> tangent_plane(const ProbeInWorld& probe, const glm::dvec3& preferred_u) {
    const glm::dvec3 t0 = probe.tangents[0].xyz, t1 = probe.tangents[1].xyz;
    const double l0 = glm::length(t0), l1 = glm::length(t1);
    if (!(l0 > 0.0) || !(l1 > 0.0)) return std::nullopt;
    const glm::dvec3 across = glm::cross(t0 / l0, t1 / l1);
    if (glm::length(across) < 1e-9) return std::nullopt;
    const glm::dvec3 n = glm::normalize(across);
    glm::dvec3 u = preferred_u - glm::dot(preferred_u, n) * n;
    u = glm::length(u) > 1e-3 ? glm::normalize(u) : t0 / l0;
    return TangentPlane{probe.point.xyz, n, u, glm::cross(n, u)};
}

void add_angle_label(Pane& pane, const std::vector<glm::dvec3>& arc, double degrees, const glm::vec3& color) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f\u00B0", degrees);
    const glm::dvec3 at = pane.view.pixel({arc[arc.size() / 2]});
    if (at.z > 0.0)
        pane.labels.push_back({Label::Role::Angle, glm::vec2(pane.rect.origin) + glm::vec2(at), text, color});
}

bool parallel(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(glm::cross(a, b)) < 1e-9; }

// What the derivation's symbols stand for at the probe. The true n_world is the inverse transpose's or, where that does
// not exist, the cofactor's.
std::vector<SymbolArrow> symbol_arrows(const ProbeInWorld& probe, const Scene& scene, double length) {
    const glm::dvec3 from = probe.object.point.xyz, to = probe.point.xyz;
    std::vector<SymbolArrow> arrows;
    const auto add = [&](const Highlight& what, const glm::dvec3& base, const glm::dvec3& direction, double long_as,
                         const glm::vec3& color) {
        if (glm::length(direction) > 0.0) arrows.push_back({what, base, long_as * glm::normalize(direction), color});
    };
    add({.symbol = Symbol::NObject}, from, probe.object.normal.xyz, length,
        arrow_color(ArrowKind::Object, scene.theme));
    for (std::size_t k = 0; k < 2; ++k) {
        add({.symbol = Symbol::VObject, .tangent = k}, from, probe.object.tangents[k].xyz, 0.6 * length, kTangentColor);
        add({.symbol = Symbol::VWorld, .tangent = k}, to, probe.tangents[k].xyz, 0.6 * length, kTangentColor);
    }
    const auto& [naive, inverse_transpose, cofactor] = probe.normals;
    if (naive) add({.symbol = Symbol::NWorld, .naive = true}, to, naive->xyz, length, kNaiveColor);
    if (inverse_transpose)
        add({.symbol = Symbol::NWorld}, to, inverse_transpose->xyz, length, kInverseTransposeColor);
    else if (cofactor)
        add({.symbol = Symbol::NWorld}, to, cofactor->xyz, length, kCofactorColor);
    // M3 takes the one object to the other.
    if (glm::length(to - from) > 1e-6)
        add({.symbol = Symbol::M3}, from, to - from, glm::length(to - from), theme_colors(scene.theme).text);
    return arrows;
}

constexpr glm::vec4 kGlow(0.94f, 0.89f, 0.26f, 0.55f);

void add_highlight(Pane& pane, const Highlight& what, double radius) {
    for (const SymbolArrow& arrow : pane.symbols) {
        if (arrow.what != what) continue;
        add_arrow(pane.solids, arrow.base, arrow.vector, 1.3 * radius, glm::vec4(arrow.color, 1.0f));
        add_tube(pane.translucent, std::array{arrow.base, arrow.base + arrow.vector}, 3.4 * radius, kGlow);
    }
}

}  // namespace

void add_probe_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe, const FrameOptions& options) {
    const std::vector<ArrowKind> kinds = shown_arrows(scene, pane.rule);
    const auto shows = [&](ArrowKind kind) { return std::ranges::count(kinds, kind) > 0; };
    const auto unit_normal = [&](Rule rule) -> std::optional<glm::dvec3> {
        const auto& n = probe.normals[static_cast<std::size_t>(rule)];
        if (!n || !shows(arrow_kind(rule)) || !(glm::length(n->xyz) > 0.0)) return std::nullopt;
        return glm::normalize(n->xyz);
    };

    const double pixel = options.pixel_scale * pane.view.world_per_pixel(probe.point);
    const double length = std::max(4.6 * scene.arrows.length, 70.0 * pixel);
    const double radius = std::max(0.022 * length, 1.7 * pixel);
    const double line = std::max(0.007, 1.1 * pixel);
    const glm::dvec3 centre = probe.point.xyz;

    pane.symbols = symbol_arrows(probe, scene, length);
    if (options.highlight) add_highlight(pane, *options.highlight, radius);

    // The naive normal's lean decides how the plane is turned, so that the error shows in profile.
    const std::optional<glm::dvec3> naive = unit_normal(Rule::Naive);
    const std::optional<glm::dvec3> correct = unit_normal(Rule::InverseTranspose);
    const auto plane = tangent_plane(probe, naive.value_or(glm::dvec3(0.0)));

    if (scene.show.tangent_plane && plane) {
        const double half = 0.62 * length;
        const glm::vec4 blue(kTangentColor, 1.0f);
        // Lifted a little, or it would flicker against the surface that it touches.
        const double side = glm::dot(plane->normal, pane.view.eye().xyz - centre) < 0.0 ? -1.0 : 1.0;
        const glm::dvec3 lifted = centre + side * 0.012 * plane->normal;
        const bool pointed_at = options.highlight && options.highlight->symbol == Symbol::Zero;
        add_patch(pane.translucent, lifted, half * plane->u, half * plane->v,
                  pointed_at ? kGlow : glm::vec4(kTangentColor, 0.20f));
        const std::array rim{lifted - half * plane->u - half * plane->v, lifted + half * plane->u - half * plane->v,
                             lifted + half * plane->u + half * plane->v, lifted - half * plane->u + half * plane->v};
        add_tube(pane.solids, rim, 0.7 * line, blue, true);
        for (const Vector<World>& t : probe.tangents)
            if (glm::length(t.xyz) > 0.0)
                add_arrow(pane.solids, centre, 0.6 * length * glm::normalize(t.xyz), 0.6 * radius, blue);
    }
    if (!scene.show.probe) return;

    if (shows(ArrowKind::Object) && scene.show.ghost)
        add_arrow(pane.solids, probe.object.point.xyz, length * probe.object.normal.xyz,
                  ArrowProportions::kOfObject * radius, glm::vec4(arrow_color(ArrowKind::Object, scene.theme), 1.0f));

    add_ball(pane.solids, centre, 1.8 * radius, glm::vec4(theme_colors(scene.theme).text, 1.0f));
    for (const Rule rule : kRules) {
        const auto n = unit_normal(rule);
        if (!n) continue;
        const glm::vec4 color(rule_color(rule), 1.0f);
        // Where the cofactor agrees with the inverse transpose, let it stand inside as a shorter, thicker arrow.
        const bool hidden = rule == Rule::Cofactor && correct && glm::dot(*correct, *n) > 0.0 && parallel(*correct, *n);
        const double long_as = (hidden ? 0.7 : 1.0) * length, wide = (hidden ? 1.35 : 1.0) * radius;
        add_arrow(pane.solids, centre, long_as * *n, wide, color);
        if (rule == Rule::Cofactor)
            add_arrow(pane.solids, centre,
                      (long_as - ArrowProportions::kToSecondHead * ArrowProportions::kHeadLength * wide) * *n, wide,
                      color);
        if (!scene.show.tangent_plane || !plane) continue;
        // A right angle gets its square; any other gets an arc down to the plane, on the side to which the arrow leans.
        const glm::dvec3 up = glm::dot(plane->normal, *n) < 0.0 ? -plane->normal : plane->normal;
        if (parallel(up, *n)) {
            const double arm = 0.2 * length;
            const glm::dvec3 along = -plane->u;
            add_tube(pane.solids, std::array{centre + arm * along, centre + arm * along + arm * up, centre + arm * up},
                     line, color);
        } else {
            const glm::dvec3 foot = glm::normalize(*n - glm::dot(*n, up) * up);
            const std::vector<glm::dvec3> arc = arc_between(centre, foot, *n, 0.3 * length);
            add_tube(pane.solids, arc, line, color);
            if (!correct) add_angle_label(pane, arc, *angle_degrees(foot, *n), rule_color(rule));
        }
    }

    if (naive && correct && !parallel(*naive, *correct)) {
        const std::vector<glm::dvec3> arc = arc_between(centre, *naive, *correct, 0.78 * length);
        add_tube(pane.solids, arc, line, glm::vec4(theme_colors(scene.theme).text, 1.0f));
        add_angle_label(pane, arc, *angle_degrees(*naive, *correct), theme_colors(scene.theme).text);
    }
}

}  // namespace normalscope

#include "core/picture/probe_marks.h"

#include "core/base/decimal.h"
#include "core/frame/arcs.h"
#include "core/frame/frame_options.h"
#include "core/frame/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

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
    const bool edges = !probe.polygon.empty();
    for (std::size_t k = 0; k < 2; ++k) {
        const glm::dvec3 v_object = probe.object.tangents[k].xyz, v_world = probe.tangents[k].xyz;
        const auto as_long = [&](const glm::dvec3& v) { return edges ? glm::length(v) : 0.6 * length; };
        add({.symbol = Symbol::VObject, .tangent = k}, edges ? probe.object.polygon[k].xyz : from, v_object,
            as_long(v_object), kTangentColor);
        add({.symbol = Symbol::VWorld, .tangent = k}, edges ? probe.polygon[k].xyz : to, v_world, as_long(v_world),
            kTangentColor);
    }
    const auto &naive = probe.normals[Rule::Naive], &inverse_transpose = probe.normals[Rule::InverseTranspose],
               &cofactor = probe.normals[Rule::Cofactor];
    if (!probe.affine) {
        if (probe.truth) add({.symbol = Symbol::NWorld}, to, probe.truth->xyz, length, theme_colors(scene.theme).text);
        if (naive) add({.symbol = Symbol::NWorld, .naive = true}, to, naive->xyz, length, kNaiveColor);
        return arrows;
    }
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

// Of the probe's arrows, in world units: a few times as long as the others, and never too short to be seen. `unit` as
// Frame::unit.
double long_as(const Pane& pane, const Scene& scene, const glm::dvec3& at, double unit, double pixel_scale) {
    constexpr double kOfOthers = 5.6, kLeastPixels = 70.0;
    return std::max(kOfOthers * unit * scene.arrows.length,
                    kLeastPixels * pixel_scale * pane.view.world_per_pixel({at}));
}

constexpr glm::vec4 kGlow(0.94f, 0.89f, 0.26f, 0.55f);

void add_highlight(Pane& pane, const Highlight& what, double radius) {
    for (const SymbolArrow& arrow : pane.symbols) {
        if (arrow.what != what) continue;
        add_arrow(pane.solids, arrow.base, arrow.vector, 1.3 * radius, glm::vec4(arrow.color, 1.0f));
        add_tube(pane.translucent, std::array{arrow.base, arrow.base + arrow.vector}, 3.4 * radius, kGlow);
    }
}

/// What is drawn at the probe, in lengths that the picture gives.
class Marks {
public:
    Marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe, const std::vector<ArrowKind>& kinds,
          const FrameOptions& options)
        : pane_(pane),
          scene_(scene),
          probe_(probe),
          kinds_(kinds),
          options_(options),
          centre_(probe.point.xyz),
          ink_(theme_colors(scene.theme).text),
          paper_(theme_colors(scene.theme).background_top) {
        const double pixel = options.pixel_scale * pane.view.world_per_pixel(probe.point);
        length_ = long_as(pane, scene, centre_, options.unit, options.pixel_scale);
        radius_ = std::max(0.022 * length_, 1.7 * pixel);
        line_ = std::max(0.007 * options.unit, 1.1 * pixel);
        naive_ = unit_normal(Rule::Naive);
        if (probe.truth) truth_ = glm::normalize(probe.truth->xyz);
        if (!probe.affine) by_no_rule_ = truth_;
        correct_ = by_no_rule_ ? by_no_rule_ : unit_normal(Rule::InverseTranspose);
        // The naive normal's lean decides how the plane is turned, so that the error shows in profile.
        plane_ = tangent_plane(probe, naive_.value_or(glm::dvec3(0.0)));
    }

    void symbols() {
        pane_.symbols = symbol_arrows(probe_, scene_, length_);
        if (options_.highlight) add_highlight(pane_, *options_.highlight, radius_);
    }

    void plane() {
        if (!scene_.show.tangent_plane || !plane_ || !probe_.object.polygon.empty()) return;
        const glm::dvec3 u = 0.56 * length_ * plane_->u, v = 0.56 * length_ * plane_->v;
        const glm::vec4 blue(color_of({.symbol = Symbol::VWorld}, kTangentColor), 1.0f);
        // Lifted a little, or it would flicker against the surface that it touches.
        const double side = glm::dot(plane_->normal, pane_.view.eye().xyz - centre_) < 0.0 ? -1.0 : 1.0;
        const glm::dvec3 lifted = centre_ + side * 0.012 * options_.unit * plane_->normal;
        keep_clear(pane_, std::array{lifted - u - v, lifted + u - v, lifted + u + v, lifted - u + v, lifted - u - v});
        const bool pointed_at = options_.highlight && options_.highlight->symbol == Symbol::Zero;
        add_patch(pane_.translucent, lifted, u, v, pointed_at ? kGlow : glm::vec4(kTangentColor, 0.20f));
        const std::array rim{lifted - u - v, lifted + u - v, lifted + u + v, lifted - u + v};
        add_tube(pane_.solids, rim, 0.7 * line_, blue, true);
        for (const Vector<World>& t : probe_.tangents) {
            if (!(glm::length(t.xyz) > 0.0)) continue;
            const glm::dvec3 along = 0.6 * length_ * glm::normalize(t.xyz);
            add_arrow(pane_.solids, centre_, along, 0.6 * radius_, blue);
            keep_clear(pane_, std::array{centre_, centre_ + along}, 0.6 * kHead * radius_);
        }
    }

    void arrows() {
        // Not as long as beside a large object far away.
        const double most = 2.0 * long_as(pane_, scene_, probe_.object.point.xyz, 1.0, options_.pixel_scale);
        if (shows(ArrowKind::Object) && scene_.show.ghost) {
            const glm::dvec3 from = probe_.object.point.xyz, n = std::min(length_, most) * probe_.object.normal.xyz;
            const glm::vec3 grey = color_of({.symbol = Symbol::NObject}, arrow_color(ArrowKind::Object, scene_.theme));
            add_arrow(pane_.solids, from, n, ArrowProportions::kOfObject * radius_, glm::vec4(grey, 1.0f),
                      ArrowLook::Hollow, paper_);
            keep_clear(pane_, std::array{from, from + n}, kHead * ArrowProportions::kOfObject * radius_);
        }
        add_ball(pane_.solids, centre_, 1.8 * radius_, glm::vec4(ink_, 1.0f));
        if (by_no_rule_) normal_by_no_rule(*by_no_rule_);
        for (const Rule rule : kRules) {
            if (const auto n = unit_normal(rule))
                arrow(rule, *n);
            else if (probe_.normals[rule] && shows(arrow_kind(rule)))
                named_.push_back({normal_formula(rule, scene_) + " = 0", {}, centre_, rule_color(rule)});
        }
    }

    void errors() {
        if (!by_no_rule_) {
            if (naive_ && correct_ && !parallel(*naive_, *correct_)) arc(*naive_, *correct_, 0.78, ink_);
            return;
        }
        std::vector<glm::dvec3> held;  // of rules that agree one tells enough
        for (const Rule rule : kRules) {
            const auto n = unit_normal(rule);
            if (!n || parallel(*n, *correct_) ||
                std::ranges::any_of(held, [&](const glm::dvec3& other) { return parallel(other, *n); }))
                continue;
            arc(*n, *correct_, 0.78 - 0.1 * static_cast<double>(held.size()), ink_);
            held.push_back(*n);
        }
    }

    /// At its tip each arrow says whose it is, and by how much it is off; those that lie on each other say it together.
    void names() {
        for (std::size_t i = 0; i < named_.size(); ++i) {
            const Named& named = named_[i];
            const auto lies_on_it = [&](const Named& other) {
                return glm::dot(other.n, named.n) > 0.0 && parallel(other.n, named.n);
            };
            if (std::any_of(named_.begin(), named_.begin() + static_cast<std::ptrdiff_t>(i), lies_on_it)) continue;
            std::string who = named.who;
            for (std::size_t k = i + 1; k < named_.size(); ++k)
                if (lies_on_it(named_[k])) who += ", " + named_[k].who;
            pane_.wanted.push_back({named.tip, who + verdict(named.n), named.color});
        }
    }

private:
    static constexpr double kHead = ArrowProportions::kHeadRadius;
    bool shows(ArrowKind kind) const { return std::ranges::count(kinds_, kind) > 0; }
    std::optional<glm::dvec3> unit_normal(Rule rule) const {
        const auto& n = probe_.normals[rule];
        if (!n || !shows(arrow_kind(rule)) || !(glm::length(n->xyz) > 0.0)) return std::nullopt;
        return glm::normalize(n->xyz);
    }

    // Of what a lesson lets stand out, and of the rest.
    glm::vec3 color_of(Highlight what, const glm::vec3& color) const {
        const auto& stands_out = options_.marks.highlight;
        if (stands_out) what.tangent = stands_out->tangent;
        return stands_out && what != *stands_out ? muted(color, scene_.theme) : color;
    }

    // Where M is not affine no rule gives the normal: it stands there by itself, and each rule's arrow is held against it.
    void normal_by_no_rule(const glm::dvec3& n) {
        add_arrow(pane_.solids, centre_, length_ * n, radius_, glm::vec4(ink_, 1.0f));
        named_.push_back({"n", n, centre_ + length_ * n, ink_});
        keep_clear(pane_, std::array{centre_, centre_ + length_ * n}, kHead * radius_);
        if (scene_.show.tangent_plane && plane_) right_angle(n, glm::vec4(ink_, 1.0f));
    }

    void arrow(Rule rule, const glm::dvec3& n) {
        const glm::vec4 color(color_of({.symbol = Symbol::NWorld, .naive = rule == Rule::Naive}, rule_color(rule)),
                              1.0f);
        // Where the cofactor agrees with the inverse transpose, let it stand inside as a shorter, thicker arrow.
        const bool hidden =
            rule == Rule::Cofactor && correct_ && glm::dot(*correct_, n) > 0.0 && parallel(*correct_, n);
        // And where the naive rule's does, its dashes go around the other's shaft.
        const bool around = rule == Rule::Naive && correct_ && glm::dot(*correct_, n) > 0.0 && parallel(*correct_, n);
        const double wide = hidden ? 1.35 : around ? ArrowProportions::kAround : 1.0;
        add_arrow(pane_.solids, centre_, (hidden ? 0.7 : 1.0) * length_ * n, wide * radius_, color,
                  arrow_look(arrow_kind(rule)), paper_);
        const glm::dvec3 tip = centre_ + length_ * n;
        keep_clear(pane_, std::array{centre_, tip}, wide * kHead * radius_);
        const bool wrong_plane = about_tangents(scene_.mistake) && scene_.rule == Rule::Naive;
        if (!wrong_plane) named_.push_back({normal_formula(rule, scene_), n, tip, glm::vec3(color)});
        if (!scene_.show.tangent_plane || !plane_) return;
        // A right angle gets its square; any other gets an arc down to the plane, on the side to which the arrow leans, or
        // by itself one to where it should stand.
        const glm::dvec3 up = glm::dot(plane_->normal, n) < 0.0 ? -plane_->normal : plane_->normal;
        if (parallel(up, n)) return right_angle(up, color);
        if (correct_ || wrong_plane) {
            const glm::dvec3 foot = glm::normalize(n - glm::dot(n, up) * up);
            const std::vector<glm::dvec3> down = arc(foot, n, 0.3, rule_color(rule));
            if (!correct_)
                named_.push_back(
                    {in_degrees(foot, n) + " to the tangents", {}, down[down.size() / 2], rule_color(rule)});
            return;
        }
        const std::array upward{centre_, centre_ + 0.9 * length_ * up};
        add_tube(pane_.solids, upward, line_, glm::vec4(ink_, 1.0f));
        keep_clear(pane_, upward);
        arc(up, n, 0.6, rule_color(rule));
    }

    void right_angle(const glm::dvec3& up, const glm::vec4& color) {
        const glm::dvec3 from = centre_ - 0.2 * length_ * plane_->u, rise = 0.2 * length_ * up;
        const std::array corner{from, from + rise, centre_ + rise};
        add_tube(pane_.solids, corner, line_, color);
        keep_clear(pane_, corner);
    }

    // Between two unit vectors.
    std::vector<glm::dvec3> arc(const glm::dvec3& a, const glm::dvec3& b, double reach, const glm::vec3& color) {
        std::vector<glm::dvec3> points = arc_between(centre_, a, b, reach * length_);
        add_tube(pane_.solids, points, line_, glm::vec4(color, 1.0f));
        keep_clear(pane_, points);
        return points;
    }

    // What the image says of an arrow: nothing where M leaves it no normal.
    std::string verdict(const glm::dvec3& n) const {
        if (!truth_ || n == glm::dvec3(0.0)) return {};
        return parallel(*truth_, n) ? " \u22A5 surface" : ": " + in_degrees(*truth_, n) + " off";
    }

    static std::string in_degrees(const glm::dvec3& a, const glm::dvec3& b) {
        return with_decimals(*angle_degrees(a, b), 1) + "\u00B0";
    }

    Pane& pane_;
    const Scene& scene_;
    const ProbeInWorld& probe_;
    const std::vector<ArrowKind>& kinds_;
    const FrameOptions& options_;
    glm::dvec3 centre_;
    glm::vec3 ink_, paper_;
    double length_ = 0.0, radius_ = 0.0, line_ = 0.0;
    struct Named {
        std::string who;
        glm::dvec3 n, tip;  ///< n: 0 where it is no arrow that is named
        glm::vec3 color;
    };
    std::vector<Named> named_;
    /// Of unit length: the naive rule's and the right one, as far as they are shown; the latter is no rule's where M is not
    /// affine.
    std::optional<glm::dvec3> naive_, correct_, by_no_rule_;
    std::optional<glm::dvec3> truth_;  ///< the image's normal, drawn or not
    std::optional<TangentPlane> plane_;
};

}  // namespace

double cleared_by_probe(const Pane& pane, const Scene& scene, const ProbeInWorld& probe, const FrameOptions& options) {
    if (!scene.show.probe && !scene.show.tangent_plane) return 0.0;
    return 0.8 * long_as(pane, scene, probe.point.xyz, options.unit, options.pixel_scale);
}

void add_probe_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe, const std::vector<ArrowKind>& kinds,
                     const FrameOptions& options) {
    Marks marks(pane, scene, probe, kinds, options);
    marks.symbols();
    marks.plane();
    if (!scene.show.probe) return;
    marks.arrows();
    if (options.right_power != -1.0) return;  // what is still on its way says nothing of how far off it is
    marks.errors();
    marks.names();
}

}  // namespace normalscope

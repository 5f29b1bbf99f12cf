#include "core/picture/ray_marks.h"

#include "core/base/decimal.h"
#include "core/frame/arcs.h"
#include "core/frame/frame_options.h"
#include "core/frame/label_room.h"
#include "core/frame/solids.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

constexpr double kNormal = 0.75;  ///< a unit normal's arrow, in the picture's units
constexpr double kBeyond = 5.2;   ///< how far a ray that misses is drawn
constexpr int kMostBeads = 40;

class Marks {
public:
    Marks(Pane& pane, const Scene& scene, const RaySteps& ray, const FrameOptions& options)
        : pane_(pane),
          ray_(ray),
          step_(std::min(scene.ray->step, ray.last_step)),
          colors_(theme_colors(scene.theme)),
          scale_(options.pixel_scale),
          unit_(options.unit) {
        pixel_ = scale_ * pane.view.world_per_pixel(ray.point_world.value_or(ray.world.origin));
    }

    void spaces(Point<World> middle) {
        const glm::dvec3 object = pane_.view.pixel({}), world = pane_.view.pixel(middle);
        // Where one hides the other, the words would, too.
        if (object.z <= 0.0 || world.z <= 0.0 || glm::distance(glm::dvec2(object), glm::dvec2(world)) < 110.0 * scale_)
            return;
        LabelRoom room(pane_, scale_);
        room.put_at(glm::dvec2(object), "object space", Label::Role::Axis, colors_.ghost);
        room.put_at(glm::dvec2(world), "world", Label::Role::Axis, colors_.text);
    }

    void world() {
        const glm::dvec3 o = ray_.world.origin.xyz, d = ray_.world.direction.xyz;
        const bool hit = step_ >= 2 && ray_.t;
        half_line(o, d, ray_.t.value_or(kBeyond * unit_), hit, colors_.text, 1.0);
        word(o, "o", colors_.text);
        word(o + d, "o + d", colors_.text);
        if (hit) {
            const glm::dvec3 p = ray_.point_world->xyz;
            add_ball(pane_.solids, p, std::max(0.03 * unit_, 4.0 * pixel_), glm::vec4(colors_.text, 1.0f));
            word(p, (step_ >= 3 ? "p,  t = " : "t = ") + with_decimals(*ray_.t, 3), colors_.text);
        }
    }

    void object() {
        if (step_ < 1 || !ray_.object) return;
        const glm::dvec3 o = ray_.object->origin.xyz, d = ray_.object->direction.xyz;
        const bool hit = step_ >= 2 && ray_.t;
        half_line(o, d, ray_.t.value_or(kBeyond * unit_), hit, colors_.ghost, 0.85);
        word(o, "M\u207B\u00B9 o", colors_.ghost);
        word(o + d, "M\u207B\u00B9(o + d)", colors_.ghost);
        if (!hit) return;
        const glm::dvec3 p = o + *ray_.t * d;
        add_ball(pane_.solids, p, std::max(0.03, 4.0 * pixel_), glm::vec4(colors_.ghost, 1.0f));
        word(p, (step_ >= 3 ? "M\u207B\u00B9 p,  t = " : "t = ") + with_decimals(*ray_.t, 3), colors_.ghost);
        if (step_ >= 4 && ray_.gradient) {
            const glm::dvec3 n = kNormal * glm::normalize(ray_.gradient->xyz);
            arrow(p, n, thick(1.3), colors_.ghost);
            word(p + n, ray_.f ? "\u2207f" : "n", colors_.ghost);
        }
    }

    void light() {
        if (step_ < 5 || !ray_.normal || !ray_.point_world) return;
        const glm::dvec3 p = ray_.point_world->xyz, unit = ray_.unit->xyz;
        const glm::vec3 green = kInverseTransposeColor;
        // As long against ∇f's arrow as it is against ∇f, until it is normalised.
        const double ratio = glm::length(ray_.normal->xyz) / glm::length(ray_.gradient->xyz);
        const double length = unit_ * kNormal * (step_ == 5 ? std::clamp(ratio, 0.25, 2.5) : 1.0);
        arrow(p, length * unit, thick(1.6), green);
        word(p + length * unit, step_ == 5 ? "(M\u207B\u00B9)\u1D40 " + std::string(ray_.f ? "\u2207f" : "n") : "n",
             green);
        if (step_ < 7) return;
        const glm::dvec3 l = ray_.toward_light.xyz;
        arrow(p, 1.25 * unit_ * kNormal * l, thick(1.3), colors_.text);
        word(p + 1.25 * unit_ * kNormal * l, "l, to the light", colors_.text);
        const double angle = angle_degrees(unit, l).value_or(0.0);
        if (angle < 1.0 || angle > 179.0) return;
        const std::vector<glm::dvec3> arc = arc_between(p, unit, l, 0.6 * unit_ * kNormal);
        add_tube(pane_.solids, arc, std::max(0.007 * unit_, 1.1 * pixel_), glm::vec4(colors_.text, 1.0f));
        keep_clear(pane_, arc);
        word(arc[arc.size() / 2],
             (*ray_.brightness < 0.0 ? "n\u00B7l = \u2212" : "n\u00B7l = ") +
                 with_decimals(std::abs(*ray_.brightness), 3),
             colors_.text);
    }

    // The last step's first: they are what one looks for.
    void words() {
        for (auto word = words_.rbegin(); word != words_.rend(); ++word) pane_.wanted.push_back(*word);
    }

private:
    void arrow(const glm::dvec3& base, const glm::dvec3& vector, double radius, const glm::vec3& color) {
        add_arrow(pane_.solids, base, vector, radius, glm::vec4(color, 1.0f));
        pane_.strokes.push_back({base, base + vector, ArrowProportions::kHeadRadius * radius});
    }
    double thick(double factor) const { return std::max(0.018 * unit_ * factor, 1.7 * factor * pixel_); }

    // With a bead at each whole t: the two rays have them at the same t.
    void half_line(const glm::dvec3& o, const glm::dvec3& d, double end, bool hit, const glm::vec3& color,
                   double factor) {
        const double radius = factor * std::max(0.010 * unit_, 1.3 * pixel_);
        const glm::vec4 ink(color, 1.0f);
        // Beyond the hit there is nothing to follow.
        const glm::dvec3 last = o + (hit ? end : std::max(end, 1.2)) * d;
        add_tube(pane_.solids, std::array{o, last}, radius, ink);
        pane_.strokes.push_back({o, last, radius});
        add_arrow(pane_.solids, o, d, 1.9 * radius, ink);
        pane_.strokes.push_back({o, o + d, 1.9 * ArrowProportions::kHeadRadius * radius});
        for (int k = 2; k < end && k < kMostBeads; ++k) add_ball(pane_.solids, o + double(k) * d, 2.4 * radius, ink);
    }

    // Written when all that they must not hide is known.
    void word(const glm::dvec3& at, const std::string& text, const glm::vec3& color) {
        words_.push_back({at, text, color});
    }

    Pane& pane_;
    const RaySteps& ray_;
    int step_;
    ThemeColors colors_;
    float scale_;
    double unit_, pixel_ = 0.0;
    std::vector<WantedLabel> words_;
};

}  // namespace

void add_ray_marks(Pane& pane, const Scene& scene, const RaySteps& ray,
                   const Transform<World, Object>& world_from_object, bool ghost, const FrameOptions& options) {
    Marks marks(pane, scene, ray, options);
    if (ghost) marks.spaces(world_from_object(Point<Object>{}));
    marks.world();
    marks.object();
    marks.light();
    marks.words();
}

}  // namespace normalscope

#include "core/picture/slice_marks.h"

#include "core/base/decimal.h"
#include "core/frame/frame_options.h"
#include "core/frame/label_room.h"
#include "core/frame/picture_scale.h"
#include "core/frame/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

namespace {

struct BandColors {
    glm::vec3 near_inside, far_inside, near_outside, far_outside;
};
// Warm against cool, which colour-blind viewers keep apart; the arrows' colours stand out from both.
constexpr BandColors band_colors(Theme theme) {
    if (is_dark(theme)) return {rgb(0x8D7650), rgb(0x4A3B22), rgb(0x5E7487), rgb(0x243442)};
    return {rgb(0xF3E2BF), rgb(0xC0924E), rgb(0xDDE8F0), rgb(0x7593AB)};
}
constexpr std::array kNamedLevels{0, 1, -1, 2, -2, 4, 8};
constexpr int kDeepest = 8;  // bands from zero to the deepest colour

// Flat, in a plane, and as wide as `half` on either side.
void add_ribbon(Solids& solids, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal, double half,
                const glm::vec4& color) {
    const glm::dvec3 along = b - a;
    const double length = glm::length(along);
    if (!(length > 0.0)) return;
    // A little too long at both ends: no gaps between the pieces of a bent line.
    const glm::dvec3 u = (0.5 + 0.6 * half / length) * along, v = half * glm::cross(normal, along / length);
    add_patch(solids, 0.5 * (a + b), u, v, color);
}

std::string level_text(double c) { return (c < 0.0 ? "\u2212" : "") + with_digits(std::abs(c), 6); }

class Marks {
public:
    Marks(Pane& pane, const Scene& scene, const LevelSets& sets, const FrameOptions& options)
        : pane_(pane), sets_(sets), theme_(scene.theme), scale_(options.pixel_scale), unit_(options.unit) {}

    // False where M leaves no plane of it.
    bool stand(const Transform<World, Object>& m) {
        m_ = m;
        const Point<Object> middle{sets_.middle};
        const glm::dvec3 u = m(middle, Vector<Object>{sets_.across[0]}).xyz,
                         v = m(middle, Vector<Object>{sets_.across[1]}).xyz, n = glm::cross(u, v);
        if (!m.reaches(middle) || !(glm::length(n) > 1e-9 * unit_ * unit_)) return false;
        normal_ = glm::normalize(n);
        stretch_ = picture_unit(std::max(glm::length(u), glm::length(v)));
        if (glm::dot(normal_, pane_.view.eye().xyz - at(sets_.middle)) < 0.0) normal_ = -normal_;
        pixel_ = scale_ * pane_.view.world_per_pixel({at(sets_.middle)});
        return true;
    }

    void bands() {
        // A little larger than they are: where one's side meets another's corner, rounding would leave holes.
        const double overlap = 3e-4 * sets_.reach;
        for (const LevelSets::Patch& patch : sets_.patches) {
            const glm::vec4 color(band_color(patch.band, theme_), 1.0f);
            const glm::dvec3 middle = (patch.corners[0] + patch.corners[1] + patch.corners[2]) / 3.0;
            for (const glm::dvec3& corner : patch.corners) {
                const glm::dvec3 away = corner - middle;
                const double length = glm::length(away);
                const glm::dvec3 moved = length > 0.0 ? corner + overlap / length * away : corner;
                pane_.solids.push_back({glm::vec3(at(moved)), glm::vec3(0.0f), color});
            }
        }
    }

    void lines(const std::optional<glm::vec3>& grey) {
        const glm::vec3 text = theme_colors(theme_).text;
        for (const LevelSets::Line& line : sets_.lines) {
            const bool zero = line.level == 0;
            const glm::vec3 quiet = glm::mix(band_color(line.level, theme_), text, 0.45f);
            // Lifted off the bands, those of zero above the others.
            const glm::dvec3 lifted = (zero ? 0.006 : 0.004) * unit_ * normal_;
            const double half = grey ? (zero ? 0.9 : 0.45) : (zero ? 1.9 : 0.6);
            add_ribbon(pane_.solids, at(line.ends[0]) + lifted, at(line.ends[1]) + lifted, normal_, half * pixel_,
                       glm::vec4(grey.value_or(zero ? text : quiet), 1.0f));
        }
    }

    void arrows(const NormalMap& map, const glm::vec3& color, double shrink) {
        std::vector<double> lengths;
        for (const LevelSets::Arrow& arrow : sets_.gradients) lengths.push_back(glm::length(map(arrow.gradient).xyz));
        if (lengths.empty()) return;
        std::vector<double> sorted = lengths;
        const auto high = sorted.begin() + static_cast<std::ptrdiff_t>(9 * sorted.size() / 10);
        std::nth_element(sorted.begin(), high, sorted.end());
        const double longest = 0.30 * stretch_ * sets_.reach;
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            if (!(lengths[i] > 0.0)) continue;
            // The root: what is ten times as steep is still longer, and the shorter one still an arrow.
            const double length = longest * std::sqrt(std::min(1.0, lengths[i] / *high));
            const glm::dvec3 base = at(sets_.gradients[i].base.xyz),
                             arrow = (shrink * length / lengths[i]) * map(sets_.gradients[i].gradient).xyz;
            const double radius = std::min(0.07 * length, std::max(0.013 * unit_, 1.9 * pixel_));
            arrows_.push_back({{base, base + arrow, ArrowProportions::kHeadRadius * radius}, color});
        }
    }

    /// Away from the arrows where they can be, and what still lies under a word is left out.
    void words() {
        LabelRoom room(pane_, scale_);
        for (const Arrow& arrow : arrows_) room.keep_clear(arrow.stroke);
        put_words(room);
        std::erase_if(arrows_, [&](const Arrow& arrow) { return room.meets_word(arrow.stroke); });
    }

    void draw_arrows() {
        for (const auto& [stroke, color] : arrows_) {
            pane_.strokes.push_back(stroke);
            add_arrow(pane_.solids, stroke.a, stroke.b - stroke.a, stroke.half_width / ArrowProportions::kHeadRadius,
                      glm::vec4(color, 1.0f));
        }
    }

private:
    void put_words(LabelRoom& room) {
        const glm::vec3 text = theme_colors(theme_).text;
        const auto side = [&](const std::optional<glm::dvec3>& where, const char* name) {
            if (!where) return;
            const glm::dvec3 p = pixel(*where);
            if (p.z > 0.0) room.put_at(glm::dvec2(p), name, Label::Role::Side, text);
        };
        side(sets_.inside, "inside  f < 0");
        side(sets_.outside, "outside  f > 0");
        // Where arrows are, the fewer words the fewer of them must go.
        const std::size_t levels = arrows_.empty() ? kNamedLevels.size() : 3;
        for (const int level : std::span(kNamedLevels).first(levels)) {
            const std::string name = level == 0 ? "f = 0" : level_text(level * sets_.step);
            if (const auto where = place_for(room, level, name)) room.put_at(*where, name, Label::Role::Level, text);
        }
    }
    glm::dvec3 at(const glm::dvec3& p) const { return m_(Point<Object>{p}).xyz; }
    glm::dvec3 pixel(const glm::dvec3& p) const { return pane_.view.pixel({at(p)}); }

    // On the level's line, which the word's box breaks: away from the arrows and other words, rather below and to the
    // left, so that the levels stand in order.
    std::optional<glm::dvec2> place_for(const LabelRoom& room, int level, const std::string& name) const {
        constexpr std::size_t kMostPlaces = 200;  // among the lines' ends and middles
        const auto count = static_cast<std::size_t>(std::ranges::count(sets_.lines, level, &LevelSets::Line::level));
        const std::size_t every = 1 + 2 * count / kMostPlaces;
        const glm::dvec2 half = room.half_size(name, Label::Role::Level), size(pane_.rect.size);
        const double clear = 1.3 * half.x;
        std::optional<glm::dvec2> best;
        double most = -1e300;
        std::size_t i = 0;
        const auto consider = [&](const glm::dvec3& place) {
            const glm::dvec3 where = pixel(place), from = place - sets_.middle;
            const glm::dvec2 p(where);
            if (!(where.z > 0.0) || glm::any(glm::lessThan(p, half)) || glm::any(glm::lessThan(size - half, p)) ||
                !room.is_free(p, name, Label::Role::Level))
                return;
            const double along = -0.8 * glm::dot(from, sets_.across[0]) - 0.6 * glm::dot(from, sets_.across[1]);
            const double score = along / sets_.reach + 2.0 * std::min(room.clearance(p) / clear, 1.0);
            if (score > most) best = p, most = score;
        };
        for (const LevelSets::Line& line : sets_.lines) {
            if (line.level != level) continue;
            for (const glm::dvec3& place : {line.ends[0], 0.5 * (line.ends[0] + line.ends[1])})
                if (i++ % every == 0) consider(place);
        }
        return best;
    }

    Pane& pane_;
    const LevelSets& sets_;
    Theme theme_;
    double scale_, unit_, stretch_ = 1.0, pixel_ = 0.0;
    Transform<World, Object> m_;
    glm::dvec3 normal_{0.0};
    struct Arrow {
        Stroke stroke;
        glm::vec3 color;
    };
    std::vector<Arrow> arrows_;
};

}  // namespace

glm::vec3 band_color(int band, Theme theme) {
    const BandColors c = band_colors(theme);
    const bool inside = band < 0;
    const float depth = std::min(1.0f, static_cast<float>(inside ? -1 - band : band) / kDeepest);
    return inside ? glm::mix(c.near_inside, c.far_inside, depth) : glm::mix(c.near_outside, c.far_outside, depth);
}

void add_slice(Pane& pane, const Scene& scene, const LevelSets& sets, const Transform<World, Object>& world_from_object,
               bool ghost, const FrameOptions& options) {
    Marks marks(pane, scene, sets, options);
    const glm::vec3 grey = theme_colors(scene.theme).ghost;
    const std::vector<ArrowKind> kinds = shown_arrows(scene, pane.rule);
    if (ghost && marks.stand({})) {
        marks.lines(grey);
        if (std::ranges::count(kinds, ArrowKind::Object) > 0) marks.arrows({}, grey, 0.8);
    }
    if (marks.stand(world_from_object)) {
        marks.bands();
        marks.lines(std::nullopt);
        if (const auto map = normal_map(scene, world_from_object, pane.rule))
            marks.arrows(*map, rule_color(pane.rule), 1.0);
        marks.words();
    }
    marks.draw_arrows();
}

}  // namespace normalscope

#include "core/picture/flat_probe_marks.h"

#include "core/base/decimal.h"
#include "core/frame/arcs.h"
#include "core/frame/drawn_arrows.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace normalscope {

namespace {

constexpr double kLongest = 2.6;   // in normals of object space: what is longer makes all of them shorter
constexpr double kShortest = 0.2;  // what that leaves of the shortest; else they are drawn as long as each other

bool parallel(glm::dvec2 a, glm::dvec2 b) { return std::abs(a.x * b.y - a.y * b.x) < 1e-9; }

// "×½": as one would say it.
std::string times(double factor) {
    static constexpr std::array<std::pair<double, const char*>, 3> kFractions{
        {{0.25, "\u00BC"}, {0.5, "\u00BD"}, {0.75, "\u00BE"}}};
    std::string text = "\u00D7";
    if (factor < 0.0) text += "\u2212";
    for (const auto& [value, sign] : kFractions)
        if (std::abs(std::abs(factor) - value) < 1e-9) return text + sign;
    return text + with_digits(std::abs(factor), 3);
}

class Marks {
public:
    Marks(Pane& pane, const Scene& scene, const Frame& frame, FlatBoard& board, const FrameOptions& options)
        : pane_(pane),
          scene_(scene),
          probe_(*frame.probe),
          view_(*frame.flat),
          plane_(view_.plane),
          board_(board),
          highlight_(options.highlight),
          colors_(theme_colors(scene.theme)),
          paper_(glm::mix(colors_.background_top, colors_.background_bottom, 0.5f)),
          kinds_(drawn_arrows(scene, world_from_object(scene), pane.rule)),
          centre_(plane_.place(probe_.point)),
          before_(probe_.object.point.xyz),
          length_(flat_probe_length(board, scene, options)) {
        choose_scale();
        stay_within();
    }

    void tangent() {
        if (!scene_.show.tangent_plane || !view_.tangent) return;
        const glm::dvec2 half = 1.4 * length_ * glm::normalize(*view_.tangent);
        board_.line(std::array{centre_ - half, centre_ + half}, {2.6, kTangentColor, kTangentLine});
        keep_clear(centre_ - half, centre_ + half);
    }

    void arrows() {
        int layer = kProbeArrows;
        if (ghost() && view_.n_object) {
            const glm::dvec2 n = length_ * scale_ * *view_.n_object;
            legs(before_, n, std::nullopt, colors_.ghost);
            board_.arrow(before_, n, {2.4, colors_.ghost, layer}, ArrowLook::Hollow, paper_);
            named_.push_back({"n", {}, before_ + n, colors_.ghost});
            keep_clear(before_, before_ + n, kHead * 2.4 * board_.pixel());
        }
        layer += 2;
        if (!probe_.affine && view_.truth)
            arrow({.who = "n", .n = length_ * glm::normalize(*view_.truth), .color = colors_.text}, ArrowLook::Plain,
                  layer);
        for (const Rule rule : {Rule::Cofactor, Rule::InverseTranspose, Rule::Naive}) {
            ++layer;
            const auto n = image(rule);
            if (!n) continue;
            const glm::vec3 color = rule_color(rule);
            if (to_scale_ && rule != Rule::Cofactor) legs(centre_, *n, view_.factors[rule], color);
            arrow({std::string(normal_formula(rule, scene_)), *n, centre_ + *n, color}, arrow_look(arrow_kind(rule)),
                  layer);
        }
    }

    void angles() {
        if (!view_.truth) return;
        const glm::dvec2 up = glm::normalize(*view_.truth);
        if (shown(Rule::InverseTranspose) || shown(Rule::Cofactor) || !probe_.affine) right_angle(up);
        const auto naive = image(Rule::Naive);
        if (!naive || parallel(glm::normalize(*naive), up)) return;
        const std::vector<glm::dvec3> arc =
            arc_between({centre_, 0.0}, {glm::normalize(*naive), 0.0}, {up, 0.0}, 0.55 * length_);
        std::vector<glm::dvec2> points(arc.begin(), arc.end());
        board_.line(points, {2.0, colors_.text, kAngles});
        for (std::size_t i = 1; i < points.size(); ++i) keep_clear(points[i - 1], points[i]);
    }

    void point() {
        if (ghost()) {
            board_.disc(before_, 4.0, colors_.ghost, kProbePoint);
        }
        board_.disc(centre_, 6.0, colors_.text, kProbePoint);
    }

    /// At its tip each arrow says whose it is, and by how much it is off; those that lie on each other say it together.
    void names() {
        for (const auto& [at, text, color] : times_) pane_.wanted.push_back({plane_.at(at).xyz, text, color});
        for (std::size_t i = 0; i < named_.size(); ++i) {
            std::string who = named_[i].who;
            bool said = false;
            for (std::size_t k = 0; k < named_.size(); ++k) {
                if (k == i || !same_way(named_[i].n, named_[k].n)) continue;
                said = said || k < i;
                who += ", " + named_[k].who;
            }
            if (!said)
                pane_.wanted.push_back({plane_.at(named_[i].tip).xyz, who + verdict(named_[i].n), named_[i].color});
        }
    }

    void symbols() {
        const auto add = [&](const Highlight& what, glm::dvec2 base, glm::dvec2 vector, const glm::vec3& color) {
            if (!(glm::length(vector) > 0.0)) return;
            const glm::dvec3 from = plane_.at(base).xyz;
            pane_.symbols.push_back({what, from, plane_.at(base + vector).xyz - from, color});
        };
        const auto unit = [&](const auto& v) { return v ? length_ * glm::normalize(*v) : glm::dvec2(0.0); };
        add({.symbol = Symbol::NObject}, before_, unit(view_.n_object), colors_.ghost);
        for (std::size_t k = 0; k < 2; ++k) {
            add({.symbol = Symbol::VObject, .tangent = k}, before_,
                0.6 * length_ * glm::dvec2(probe_.object.tangents[k].xyz), kTangentColor);
            const glm::dvec2 t = plane_.part(probe_.tangents[k].xyz);
            if (glm::length(t) > 1e-9 * glm::length(probe_.tangents[k].xyz))
                add({.symbol = Symbol::VWorld, .tangent = k}, centre_, 0.6 * length_ * glm::normalize(t),
                    kTangentColor);
        }
        add({.symbol = Symbol::NWorld}, centre_, unit(view_.truth),
            probe_.affine ? kInverseTransposeColor : colors_.text);
        add({.symbol = Symbol::NWorld, .naive = true}, centre_, unit(view_.normals[Rule::Naive]), kNaiveColor);
        add({.symbol = Symbol::M3}, before_, centre_ - before_, colors_.text);
        if (!highlight_) return;
        for (const SymbolArrow& arrow : pane_.symbols)
            if (arrow.what == *highlight_)
                board_.arrow(plane_.place({arrow.base}), plane_.part(arrow.vector), {7.0, kGlow, kTangentLine},
                             ArrowLook::Plain, paper_);
    }

private:
    static constexpr double kHead = 1.7;  ///< half of a head's width, in widths of the shaft
    static constexpr glm::vec3 kGlow{0.94f, 0.89f, 0.26f};
    struct Named {
        std::string who;
        glm::dvec2 n{0.0}, tip{0.0};  ///< n: 0 where there is nothing to judge
        glm::vec3 color{0.0f};
    };
    struct Times {
        glm::dvec2 at;
        std::string text;
        glm::vec3 color;
    };

    bool ghost() const {
        return scene_.show.ghost && std::ranges::count(kinds_, ArrowKind::Object) > 0 &&
               world_from_object(scene_).matrix() != glm::dmat4(1.0);
    }
    bool shown(Rule rule) const {
        return std::ranges::count(kinds_, arrow_kind(rule)) > 0 && view_.normals[rule].has_value();
    }

    // All by one scale, so that halves and doubles are seen as what they are; where one would be lost beside another, all are
    // of one length.
    void choose_scale() {
        double longest = 1.0, shortest = 1.0;
        for (const Rule rule : {Rule::Naive, Rule::InverseTranspose})
            if (shown(rule)) {
                longest = std::max(longest, glm::length(*view_.normals[rule]));
                shortest = std::min(shortest, glm::length(*view_.normals[rule]));
            }
        scale_ = std::min(1.0, kLongest / longest);
        to_scale_ = probe_.affine && scale_ * shortest >= kShortest;
        if (!to_scale_) scale_ = 1.0;
    }

    // Arrows that would leave the picture are all shorter, down to where they are too short to be compared. A word needs room
    // at their tips, too.
    void stay_within() {
        constexpr double kWord = 30.0, kLeast = 0.4;
        const auto pixel = [&](glm::dvec2 place) { return glm::dvec2(pane_.view.pixel(plane_.at(place))); };
        const glm::dvec2 from = pixel(centre_), size(pane_.rect.size);
        const double margin = kWord * glm::distance(pixel(centre_ + glm::dvec2(board_.pixel(), 0.0)), from);
        double part = 1.0;
        for (const Rule rule : kRules) {
            const auto n = image(rule);
            if (!n) continue;
            const glm::dvec2 way = pixel(centre_ + *n) - from;
            for (glm::length_t i = 0; i < 2; ++i) {
                const double room = way[i] < 0.0 ? from[i] - margin : size[i] - margin - from[i];
                if (std::abs(way[i]) > room && room > 0.0) part = std::min(part, room / std::abs(way[i]));
            }
        }
        length_ *= std::max(part, kLeast);
    }

    std::optional<glm::dvec2> image(Rule rule) const {
        if (!shown(rule)) return std::nullopt;
        const glm::dvec2 n = *view_.normals[rule];
        if (to_scale_ && rule != Rule::Cofactor) return length_ * scale_ * n;
        // Where the cofactor agrees with the inverse transpose, it stands within as a shorter arrow.
        const bool within = rule == Rule::Cofactor && shown(Rule::InverseTranspose) &&
                            same_way(n, *view_.normals[Rule::InverseTranspose]);
        const double of = within && to_scale_ ? scale_ * glm::length(*view_.normals[Rule::InverseTranspose]) : 1.0;
        return (within ? 0.7 : 1.0) * of * length_ * glm::normalize(n);
    }

    static bool same_way(glm::dvec2 a, glm::dvec2 b) {
        return glm::length(a) > 0.0 && glm::length(b) > 0.0 && glm::dot(a, b) > 0.0 &&
               parallel(glm::normalize(a), glm::normalize(b));
    }

    void arrow(Named named, ArrowLook look, int layer) {
        const bool dashed = look == ArrowLook::Dashed;
        board_.arrow(centre_, named.n,
                     {look == ArrowLook::TwoHeads ? 6.0
                      : dashed                    ? 4.2
                                                  : 4.6,
                      named.color, layer},
                     look, paper_);
        named.tip = centre_ + named.n;
        keep_clear(centre_, named.tip, kHead * 4.6 * board_.pixel());
        named_.push_back(std::move(named));
    }

    // Along x, then along y; what each has been multiplied by stands at its middle. Beside an arrow that lies along an axis
    // there is no room for them.
    void legs(glm::dvec2 base, glm::dvec2 vector, const std::optional<glm::dvec2>& factors, const glm::vec3& color) {
        const double least = 12.0 * board_.pixel();
        const bool room = std::abs(vector.x) > least && std::abs(vector.y) > least;
        const glm::dvec2 corner = room ? base + glm::dvec2(vector.x, 0.0) : base + 0.5 * vector, tip = base + vector;
        for (glm::length_t k = 0; k < 2; ++k) {
            if (std::abs(vector[k]) <= least) continue;
            const glm::dvec2 from = k == 0 ? base : corner, to = k == 0 ? corner : tip;
            if (room) {
                board_.line(std::array{from, to}, {1.8, glm::mix(paper_, color, 0.8f), kLegs, 3.0});
                keep_clear(from, to);
            }
            if (factors && std::abs((*factors)[k] - 1.0) > 1e-9)
                times_.push_back({0.5 * (from + to), times((*factors)[k]), color});
        }
    }

    void right_angle(glm::dvec2 up) {
        if (!view_.tangent || !scene_.show.tangent_plane) return;
        const glm::dvec2 along = glm::normalize(*view_.tangent);
        if (std::abs(glm::dot(along, up)) > 1e-9) return;  // as of tangents that went by a mistake
        const double side = 0.2 * length_;
        const std::array corner{centre_ - side * along, centre_ + side * (up - along), centre_ + side * up};
        board_.line(corner, {1.8, probe_.affine ? kInverseTransposeColor : colors_.text, kAngles});
        for (std::size_t i = 1; i < corner.size(); ++i) keep_clear(corner[i - 1], corner[i]);
    }

    std::string verdict(glm::dvec2 n) const {
        if (!view_.truth || n == glm::dvec2(0.0)) return {};
        const glm::dvec2 truth = glm::normalize(*view_.truth);
        if (parallel(truth, glm::normalize(n))) return " \u22A5 curve";
        return ": " + with_decimals(*angle_degrees({truth, 0.0}, {n, 0.0}), 1) + "\u00B0 off";
    }

    void keep_clear(glm::dvec2 a, glm::dvec2 b, double half_width = 0.0) {
        pane_.strokes.push_back({plane_.at(a).xyz, plane_.at(b).xyz, half_width});
    }

    Pane& pane_;
    const Scene& scene_;
    const ProbeInWorld& probe_;
    const FlatView& view_;
    const FlatPlane& plane_;
    FlatBoard& board_;
    std::optional<Highlight> highlight_;
    ThemeColors colors_;
    glm::vec3 paper_;
    std::vector<ArrowKind> kinds_;
    glm::dvec2 centre_, before_;
    double length_, scale_ = 1.0;
    bool to_scale_ = true;
    std::vector<Named> named_;
    std::vector<Times> times_;
};

}  // namespace

double flat_probe_length(const FlatBoard& board, const Scene& scene, const FrameOptions& options) {
    return std::max(5.0 * options.unit * scene.arrows.length, 80.0 * board.pixel());
}

void add_flat_probe_marks(Pane& pane, const Scene& scene, const Frame& frame, FlatBoard& board,
                          const FrameOptions& options) {
    if (!frame.probe) return;
    Marks marks(pane, scene, frame, board, options);
    marks.symbols();
    marks.tangent();
    if (!scene.show.probe) return;
    marks.angles();
    marks.arrows();
    marks.point();
    marks.names();
}

}  // namespace normalscope

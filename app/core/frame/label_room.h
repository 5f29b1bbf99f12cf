#pragma once

#include "core/frame/frame.h"
#include "core/surface/surface.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// How much of a line lies within a box about 0.
double length_within(const glm::dvec2& half, const glm::dvec2& a, const glm::dvec2& b);

/// A stroke as a pane shows it, in its pixels.
struct StrokeInPixels {
    glm::dvec2 a, b;
    double half_width;

    /// How much of it lies within a box, which its own width makes larger.
    double length_in(const glm::dvec2& middle, const glm::dvec2& half) const {
        return length_within(half + half_width, a - middle, b - middle);
    }
};
/// Empty where an end of it lies behind the eye.
std::optional<StrokeInPixels> in_pixels(const CameraView& view, const Stroke& stroke);

/// Finds places for a pane's labels where they hide neither each other nor the lines and arrows that they name. What
/// a word takes is but estimated: fonts are not known here.
class LabelRoom {
public:
    /// The labels that the pane already has are left where they are, and what is drawn in it kept clear.
    LabelRoom(Pane& pane, double pixel_scale);

    /// Of what is not in the pane yet.
    void keep_clear(const Stroke& stroke);
    /// Of many arrows, which cover so much of the pane's pixels, convex: words may stand further away for it.
    void keep_clear_of_arrows(std::vector<glm::dvec2> area);
    /// From a pixel of the pane to the nearest such line.
    double clearance(const glm::dvec2& pixel) const;
    /// Whether a word about that pixel of the pane meets no other.
    bool is_free(const glm::dvec2& pixel, const std::string& text, Label::Role role) const;
    /// Whether a line lies under a word.
    bool meets_word(const Stroke& stroke) const;

    /// About that pixel of the pane, whatever is there.
    void put_at(const glm::dvec2& pixel, const std::string& text, Label::Role role, const glm::vec3& color);
    /// On whichever side is the most free; nothing where its place lies behind the eye.
    void put_beside(const WantedLabel& wanted);

    glm::dvec2 half_size(const std::string& text, Label::Role role) const;

private:
    struct Box {
        glm::dvec2 middle, half;
    };
    double hidden_by(const Box& box, const std::vector<StrokeInPixels>& near) const;
    std::vector<StrokeInPixels> lines_near(const glm::dvec2& pixel, const glm::dvec2& reach) const;

    Pane& pane_;
    double scale_;
    std::vector<Box> taken_;
    std::vector<StrokeInPixels> lines_;
    std::vector<std::vector<glm::dvec2>> areas_;
    std::vector<glm::dvec2> arrows_;  ///< corners of what they cover
};

/// Arrows that are few enough to be told apart: words keep clear of each. More are an area.
inline constexpr std::size_t kFewArrows = 400;

/// Convex corners, in order, about where the object is in the pane, with its arrows where they are many.
std::vector<glm::dvec2> outline_of(const Pane& pane, const Surface& surface,
                                   const Transform<World, Object>& world_from_object);
/// How much of a box lies within a convex polygon, 0 to 1.
double share_within(const std::vector<glm::dvec2>& convex, const glm::dvec2& low, const glm::dvec2& high);
/// At last, when all is drawn: the words that the pane wants.
void place_labels(Pane& pane, const Surface& surface, const Transform<World, Object>& world_from_object,
                  double pixel_scale);

}  // namespace normalscope

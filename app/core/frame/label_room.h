#pragma once

#include "core/frame/frame.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <vector>

namespace normalscope {

/// Finds places for a pane's labels where they hide neither each other nor the lines and arrows that they name. What
/// a word takes is but estimated: fonts are not known here.
class LabelRoom {
public:
    /// The labels that the pane already has are left where they are, and its lines kept clear.
    LabelRoom(Pane& pane, double pixel_scale);

    /// A line or an arrow in world space, which words had better not cross.
    void keep_clear(const glm::dvec3& a, const glm::dvec3& b);
    /// From a pixel of the pane to the nearest such line.
    double clearance(const glm::dvec2& pixel) const;
    /// Whether a word about that pixel of the pane meets no other.
    bool is_free(const glm::dvec2& pixel, const std::string& text, Label::Role role) const;

    /// About that pixel of the pane, whatever is there.
    void put_at(const glm::dvec2& pixel, const std::string& text, Label::Role role, const glm::vec3& color);
    /// Near a place of world space, on whichever side is the most free; nothing where it lies behind the eye.
    void put_beside(const glm::dvec3& at, const std::string& text, const glm::vec3& color);

    glm::dvec2 half_size(const std::string& text, Label::Role role) const;

private:
    struct Box {
        glm::dvec2 middle, half;
    };
    double overlap(const Box& box) const;

    Pane& pane_;
    double scale_;
    std::vector<Box> taken_;
    std::vector<std::array<glm::dvec2, 2>> lines_;
};

}  // namespace normalscope

#pragma once

#include "core/frame/flat_plane.h"
#include "core/frame/frame.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace normalscope {

/// What a line is drawn with; lengths are logical pixels.
struct Pen {
    double width = 2.0;
    glm::vec3 color{0.0f};
    int layer = 0;      ///< what is higher lies over what is lower
    double dash = 0.0;  ///< as long as the gaps after it; 0: an unbroken line
};

/// Draws flat things into a pane that looks straight at a plane, places being the plane's. Within a layer nothing may overlap
/// that differs in colour; layers are to come in order, which is all that an SVG knows of them.
class FlatBoard {
public:
    FlatBoard(Pane& pane, const FlatPlane& plane, double pixel_scale);

    /// World units that a logical pixel covers.
    double pixel() const { return pixel_; }
    const FlatPlane& plane() const { return plane_; }

    void line(std::span<const glm::dvec2> points, const Pen& pen);
    void loop(std::span<const glm::dvec2> points, const Pen& pen);
    /// Convex; either sense.
    void polygon(std::span<const glm::dvec2> corners, const glm::vec3& color, int layer);
    void disc(glm::dvec2 centre, double radius, const glm::vec3& color, int layer);
    /// In the shape of its kind: a hollow head is `paper` within. Nothing where the vector is zero.
    void arrow(glm::dvec2 base, glm::dvec2 vector, const Pen& pen, ArrowLook look, const glm::vec3& paper);

private:
    enum class Ends { Open, Joined };
    void stroke(std::span<const glm::dvec2> points, Ends ends, const Pen& pen);
    void dashes(std::span<const glm::dvec2> points, const Pen& pen);

    Pane& pane_;
    const FlatPlane& plane_;
    double pixel_;
};

}  // namespace normalscope

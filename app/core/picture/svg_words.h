#pragma once

// The words of an SVG picture, and how numbers and colours are written in one.

#include "core/frame/frame.h"
#include "core/scene/palette.h"

#include <string>

namespace normalscope {

/// With two decimals, in the picture's pixels.
std::string svg_number(double v);
/// "#d55e00"
std::string svg_color(const glm::vec3& color);

/// A pane's labels as elements of an SVG.
std::string svg_labels(const Pane& pane, const ThemeColors& colors, double pixel_scale);
/// The frame's legend, at the lower left.
std::string svg_legend(const Frame& frame, double scale);

}  // namespace normalscope

#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <string>
#include <vector>

namespace normalscope {

using PlaneTriangle = std::array<glm::dvec2, 3>;
/// A closed line, without its first point again at the end.
using Loop = std::vector<glm::dvec2>;

/// The outline of triangles that lie beside each other, all turning the same way: edges that two of them share cancel.
/// Filled by the nonzero rule, the loops cover what the triangles cover, without the seams between them.
std::vector<Loop> contours(const std::vector<PlaneTriangle>& triangles);

/// The loops as an SVG path's data, in tenths of a pixel.
std::string path_data(const std::vector<Loop>& loops);
std::string open_path_data(const std::vector<glm::dvec2>& line);
std::string closed_path_data(const std::vector<glm::dvec2>& line);

}  // namespace normalscope

// The files that are built into the program: shaders, scenes, lessons, fonts.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace embedded {

// The contents of a file such as "shaders/scene.vert" or "fonts/OpenSans-Regular.ttf"; none for an unknown name.
std::optional<std::string_view> file(std::string_view name);

// Every name there is: each folder's files in alphabetical order.
std::span<const std::string_view> names();

}  // namespace embedded

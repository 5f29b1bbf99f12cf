#pragma once

#include "core/frame/frame.h"

#include <imgui.h>

#include <cstddef>

namespace normalscope {

// Dear ImGui's rounds, drawn into the bound framebuffer. Boxes are in its pixels, from the top left.

void draw_all(ImDrawData& round);
/// The same within the box, and nothing around it.
void draw_within(const ImDrawData& round, const PixelRect& box);
/// Of two rounds that have the same one, the pixels around the box are the same, too.
std::size_t hash_around(const ImDrawData& round, const PixelRect& box);

}  // namespace normalscope

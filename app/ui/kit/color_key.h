#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"

#include <string>

namespace normalscope {

/// The ground on which a legend or a key stands in the picture.
void draw_card(const Look& look, const ThemeColors& colors, ImVec2 low, ImVec2 high);

/// As wide as there is room, if there is enough for its title; else nothing.
ImVec2 color_key_size(const Look& look, float room, const std::string& title);
/// What the surface's colours stand for, the frame's color_key.
void draw_color_key(const Look& look, const Frame& frame, ImVec2 low, ImVec2 size);

}  // namespace normalscope

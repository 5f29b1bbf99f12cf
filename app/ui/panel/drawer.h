#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"

#include <glm/vec2.hpp>

namespace normalscope {

/// Whether the panel, in a framebuffer of this size, is a drawer below the picture: where that is narrow and upright, as a
/// phone's is, it would hide the picture at the left.
bool is_drawer(const Look& look, glm::ivec2 framebuffer);

/// What it takes of the framebuffer's height, with the handle that is always there.
int drawer_height(const Look& look, glm::ivec2 framebuffer, bool open);

/// Where the panel goes.
PixelRect panel_place(const Look& look, glm::ivec2 framebuffer);

/// Below the picture. True where it was pressed: the drawer opens, or closes.
bool drawer_handle(const Look& look, const PixelRect& picture, bool open);

}  // namespace normalscope

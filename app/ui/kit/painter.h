#pragma once

#include "core/image/image.h"

struct ImDrawData;

namespace normalscope {

/// Paints what Dear ImGui has laid out over a picture, as its OpenGL backend would, but here: for a single picture a
/// driver on the processor would take longer to compile the shaders than this takes. The font atlas must be built.
void paint(const ImDrawData& data, Image& image);

}  // namespace normalscope

#pragma once

#include "core/math/transform.h"
#include "core/surface/surface.h"

#include <string_view>

namespace normalscope {

/// Whether it is a formula's surface that is to be met by a ray through each pixel, as far as M lets it. One whose formula
/// takes a great many steps to compute is drawn by its triangles, where it has any.
bool is_traced(const Surface& surface);

/// Why a formula's surface is drawn by its triangles; empty where it is not, or where that is all that there is to be seen.
std::string_view note_on_triangles(const Surface& surface, const Transform<World, Object>& world_from_object);

}  // namespace normalscope

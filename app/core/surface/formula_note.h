#pragma once

#include "core/surface/implicit_surface.h"

#include <string>

namespace normalscope {

/// Why there is less to be seen of a formula than one may expect; empty where there is not. `mesh` is what it was
/// polygonised to.
std::string note_on(const ImplicitSurface& surface, const Mesh& mesh);

}  // namespace normalscope

#pragma once

#include "core/mesh.h"

namespace normalscope {

/// Whether the triangles enclose solids: at each edge, as many go one way as go the other way, and every part that hangs
/// together has its inside behind its triangles. From outside, such a surface shows no triangle's back.
bool is_closed(const Mesh& mesh);

}  // namespace normalscope

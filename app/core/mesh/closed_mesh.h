#pragma once

#include "core/mesh/mesh.h"

namespace normalscope {

/// Whether at each edge as many triangles go one way as go the other way, so that there is no rim. Wrong once
/// in 2⁶⁴ cases.
bool edges_cancel(const std::vector<glm::uvec3>& triangles);

/// Whether the triangles enclose solids: at each edge, as many go one way as go the other way, and every part that hangs
/// together has its inside behind its triangles. From outside, such a surface shows no triangle's back.
bool is_closed(const Mesh& mesh);

}  // namespace normalscope

#pragma once

#include "core/math/expression.h"

#include <cstddef>

namespace normalscope {

/// One thing that stands in the equations and in the picture; pointing at it in either lights it up in both. 0 says
/// "perpendicular", and so stands for the tangent plane.
struct Highlight {
    Symbol symbol = Symbol::Zero;
    bool naive = false;       ///< n_world: the naive rule's, not the true one
    std::size_t tangent = 0;  ///< of v_obj and v_world: which of the probe's two

    friend bool operator==(const Highlight&, const Highlight&) = default;
};

}  // namespace normalscope

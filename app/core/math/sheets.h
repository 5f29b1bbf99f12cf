#pragma once

#include "core/math/transform.h"

namespace normalscope {

/// How many of a normal's sheets a step crosses. The sheets are the planes n·x = 0, d, 2d … with the spacing d, so that it
/// is n·step/d: as many as n's x says for a step along x as long as d, and none for a tangent. Sheets are carried along by
/// M as points are; the normal that the carried ones belong to is (M⁻¹)ᵀ n, as the carried step M v crosses as many of
/// them as v did before: ((M⁻¹)ᵀ n)·(M v) = n·v.
template <class Space>
double sheets_crossed(Normal<Space> n, Vector<Space> step, double spacing) {
    return dot(n, step) / spacing;
}

}  // namespace normalscope

#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace normalscope {

/// A straight piece of a curve on a surface, with the surface's normals at its ends.
struct CurvePiece {
    Site from, to;
};

/// Each piece begins where the last one ends. At a corner of the surface these two ends have normals of their own.
struct Curve {
    std::vector<CurvePiece> pieces;
    bool closed = false;
};

/// Curves of pieces in any order and of either sense, which meet where their ends are no more than `near` apart. Where more
/// than two meet, a curve goes on as straight as it can. Pieces shorter than `near` are left out.
std::vector<Curve> joined(const std::vector<CurvePiece>& pieces, double near);

}  // namespace normalscope

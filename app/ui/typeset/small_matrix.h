#pragma once

#include "core/math/value.h"
#include "ui/kit/style.h"

#include <optional>
#include <span>
#include <string>

namespace normalscope {

/// A 3×3 matrix beside others: what stands above it, and between it and the one before.
struct SmallMatrix {
    const char* label = "";
    std::optional<Value> value;  ///< the upper left 3×3 is shown; empty: a dash
    ImVec4 ink;                  ///< of the label and the brackets
    const char* about = "";      ///< for its tooltip
    const char* sign = "";       ///< "=" or "·", at its left
};

/// Matrices in one row, as wide as the column and all of one width, so that nothing moves as their numbers change.
void row_of_matrices(const Look& look, std::span<const SmallMatrix> matrices);
/// What it takes.
float height_of_matrices(const Look& look);

/// Text that wraps at the column's end.
void wrapped(const Look& look, const ImVec4& ink, const std::string& text);
/// A note with a stripe at its left: what is remarkable, without alarm.
void remark(const Look& look, const ImVec4& stripe, const std::string& text);
/// What a negative determinant means for normals: two conventions, each right for its own question.
void reflection_remark(const Look& look);

}  // namespace normalscope

#pragma once

#include "ui/kit/style.h"
#include "ui/typeset/formula_box.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// f and its partial derivatives, laid out below each other.
struct WrittenFormula {
    std::string formula;
    const ImFont* font = nullptr;
    float width = 0.0f;
    std::string parameters;  ///< those that occur
    std::array<FormulaBox, 4> boxes;
    std::array<std::string, 4> texts;  ///< in one line, where the box is not all of it
};

/// Draws the first `lines` of them, as laid out before where that still holds. `width` is that of a whole line; `values`
/// stand at its right, if there are any.
void written_formula(const Look& look, std::optional<WrittenFormula>& written, const std::string& formula, float width,
                     std::size_t lines = 4, std::span<const std::string> values = {});

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"
#include "ui/typeset/written_formula.h"

#include <optional>

namespace normalscope {

/// f and ∇f at the probe as formulas and as numbers, and beside the exact normal what differences and a polygon make of
/// it. Nothing for a surface that comes from no formula.
void gradient_readout(const Look& look, const Frame& frame, std::optional<WrittenFormula>& written);

}  // namespace normalscope

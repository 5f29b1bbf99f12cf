#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <string>

namespace normalscope::formulas {

/// What is wrong with a formula's text, and where: "column 7: expected a number, found the end".
struct SyntaxError : InputError {
    SyntaxError(std::size_t at, const std::string& message)
        : InputError("column " + std::to_string(at) + ": " + message), column(at) {}
    std::size_t column;  ///< in characters, the first is 1; one past the last for what is missing at the end
};

/// A longer formula's text is refused.
inline constexpr std::size_t kMostCharacters = 10'000;

}  // namespace normalscope::formulas

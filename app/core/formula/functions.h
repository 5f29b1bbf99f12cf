#pragma once

// What may be written like a function; for the lexer and the parser only.

#include "core/formula/graph.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope::formulas {

/// A function's name, and what it stands for: an Op, or what it is made of, as sqrt and exp are powers.
struct Function {
    std::string_view name;
    std::size_t fewest = 1, most = 1;  ///< arguments
    Id (*apply)(Graph& graph, std::span<const Id> args) = nullptr;
};

/// All of them.
std::span<const Function> functions();
/// Their names, with blanks between.
std::string known_functions();

}  // namespace normalscope::formulas

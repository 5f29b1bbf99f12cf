#pragma once

// The characters of a formula as tokens; for the parser only.

#include "core/formula/functions.h"
#include "core/formula/graph.h"
#include "core/formula/syntax_error.h"

#include <string>
#include <string_view>
#include <vector>

namespace normalscope::formulas {

enum class TokenType {
    Number,
    Superscript,  // ²: a power at once
    Leaf,         // x, a, pi, e
    Function,
    Plus,
    Minus,
    Times,
    Divide,
    Power,
    Open,
    Close,
    Bar,
    Comma,
    Equals,
    End
};

struct Token {
    TokenType type = TokenType::End;
    std::size_t column = 1;
    std::string text;  // as it was written
    Number number;     // of Number and Superscript
    Op op = Op::Pi;    // of Leaf
    int index = 0;     // of Leaf
    const Function* function = nullptr;
};

/// The tokens, the last of which is End. Throws SyntaxError.
std::vector<Token> tokens(std::string_view text);

}  // namespace normalscope::formulas

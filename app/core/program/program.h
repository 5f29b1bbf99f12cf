#pragma once

#include "core/formula/real.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace normalscope::formulas {

enum class Code : std::uint8_t {
    Constant,
    Parameter,  // constant is its index
    Variable,   // a is its index
    Add,
    Subtract,
    Multiply,
    Divide,
    Negate,
    IntegerPower,  // a^constant
    RealPower,     // a^constant, a real root by its parity
    Power,         // a^b
    Exp,
    Sqrt,
    Log,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Abs,
    Sign,
    Floor,
    Min,
    Max,
    Atan2,  // the angle of (b, a)
    Where,  // a where b ≤ 0, else c
};

/// One step; its operands are the numbers of earlier steps.
struct Instruction {
    Code code = Code::Constant;
    Parity parity = Parity::None;
    bool varies = false;  ///< with x, y or z
    std::uint32_t a = 0, b = 0, c = 0;
    double constant = 0.0;

    friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// An expression as steps in order; the last one's result is the value. Nothing is computed twice.
using Program = std::vector<Instruction>;

/// How many operands a step has.
int operands(Code code);

/// The total degree in x, y, z where the program is a polynomial; terms that cancel are not noticed. Empty where it is
/// none, or of a degree beyond `most`.
std::optional<int> polynomial_degree(const Program& program, int most);

}  // namespace normalscope::formulas

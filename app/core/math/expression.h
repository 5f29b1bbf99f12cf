#pragma once

#include "core/math/value.h"

#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// What a letter in an equation stands for; each has one colour (core/scene/palette.h) everywhere.
enum class Symbol { NObject, VObject, NWorld, VWorld, M3, Zero };

/// What colours a symbol: object-space things grey, tangents blue, normals by their rule.
enum class Meaning { Plain, Object, Tangent, Naive, InverseTranspose, Cofactor };

/// "n_obj", "v_obj", "n_world", "v_world", "M3", "0": as the numbers' keys and a person at a keyboard would write them.
std::string_view name(Symbol symbol);

/// A side of an equation as a tree, each part with its value, so that whoever lays it out may show any part as name or
/// as number.
struct Expression {
    enum class Kind { Symbol, Transpose, Inverse, Product, Dot, Equals } kind = Kind::Symbol;
    Symbol symbol = Symbol::Zero;  ///< of a symbol
    Meaning meaning = Meaning::Plain;
    std::vector<Expression> operands;
    std::optional<Value> value;  ///< empty where there is none, as of the inverse of a singular matrix; none of Equals
};

std::string_view name(Expression::Kind kind);

// Each computes the value of what it makes from the values of what it is made from.

Expression symbol(Symbol symbol, Meaning meaning, std::optional<Value> value);
Expression zero();
Expression transposed(Expression a);
/// `known_rank` as in normal_matrices.
Expression inverted(Expression a, std::optional<int> known_rank = {});
/// Left to right.
Expression multiplied(std::vector<Expression> factors);
Expression dot(Expression a, Expression b);
Expression equals(Expression left, Expression right);

/// True for what must stand in parentheses as `outer`'s operand.
bool needs_parentheses(const Expression& operand, Expression::Kind outer);

/// On one line, with superscripts: "(M₃⁻¹)ᵀ n_obj".
std::string expression_text(const Expression& expression);

}  // namespace normalscope

#include "core/math/expression.h"

#include <array>
#include <utility>

namespace normalscope {

std::string_view name(Symbol symbol) {
    constexpr std::array<std::string_view, 6> kNames{"n_obj", "v_obj", "n_world", "v_world", "M3", "0"};
    return kNames.at(static_cast<std::size_t>(symbol));
}

std::string_view name(Expression::Kind kind) {
    constexpr std::array<std::string_view, 6> kNames{"symbol", "transpose", "inverse", "product", "dot", "equals"};
    return kNames.at(static_cast<std::size_t>(kind));
}

Expression symbol(Symbol symbol, Meaning meaning, std::optional<Value> value) {
    return {.kind = Expression::Kind::Symbol, .symbol = symbol, .meaning = meaning, .operands = {}, .value = value};
}

Expression zero() { return symbol(Symbol::Zero, Meaning::Plain, value_of(0.0)); }

Expression transposed(Expression a) {
    Expression result{.kind = Expression::Kind::Transpose, .meaning = a.meaning};
    if (a.value) result.value = transpose(*a.value);
    result.operands.push_back(std::move(a));
    return result;
}

Expression inverted(Expression a, std::optional<int> known_rank) {
    Expression result{.kind = Expression::Kind::Inverse, .meaning = a.meaning};
    if (a.value) result.value = inverse(*a.value, known_rank);
    result.operands.push_back(std::move(a));
    return result;
}

Expression multiplied(std::vector<Expression> factors) {
    Expression result{.kind = Expression::Kind::Product};
    result.value = factors.front().value;
    for (std::size_t i = 1; i < factors.size(); ++i)
        result.value = result.value && factors[i].value ? product(*result.value, *factors[i].value) : std::nullopt;
    result.operands = std::move(factors);
    return result;
}

Expression dot(Expression a, Expression b) {
    Expression result{.kind = Expression::Kind::Dot};
    if (a.value && b.value) result.value = product(transpose(*a.value), *b.value);
    result.operands = {std::move(a), std::move(b)};
    return result;
}

Expression equals(Expression left, Expression right) {
    Expression result{.kind = Expression::Kind::Equals};
    result.operands = {std::move(left), std::move(right)};
    return result;
}

bool needs_parentheses(const Expression& operand, Expression::Kind outer) {
    using enum Expression::Kind;
    switch (outer) {
        case Transpose:
        case Inverse: return operand.kind != Symbol;
        case Dot: return operand.kind == Product || operand.kind == Dot;
        case Product: return operand.kind == Dot;
        case Symbol:
        case Equals: break;
    }
    return false;
}

std::string expression_text(const Expression& e) {
    using enum Expression::Kind;
    const auto operand = [&](std::size_t i) {
        const std::string text = expression_text(e.operands[i]);
        return needs_parentheses(e.operands[i], e.kind) ? "(" + text + ")" : text;
    };
    switch (e.kind) {
        case Symbol: return e.symbol == normalscope::Symbol::M3 ? "M₃" : std::string(name(e.symbol));
        case Transpose: return operand(0) + "ᵀ";
        case Inverse: return operand(0) + "⁻¹";
        case Dot: return operand(0) + " · " + operand(1);
        case Equals: return operand(0) + " = " + operand(1);
        case Product: break;
    }
    std::string text = operand(0);
    for (std::size_t i = 1; i < e.operands.size(); ++i) text += " " + operand(i);
    return text;
}

}  // namespace normalscope

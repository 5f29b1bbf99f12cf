// Sums, products and powers in canonical form. What they give back, given to them again, stays as it is: so what is
// printed and read again is the same expression.

#include "core/formula/graph.h"
#include "core/formula/real.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace normalscope::formulas {

// 2xy as (xy, 2).
Graph::Term Graph::split_coefficient(Id term) {
    const std::span<const Id> factors = args(term);
    if (nodes_[term].op != Op::Product || !is_number(factors[0])) return {term, 1};
    const Number coefficient = nodes_[factors[0]].number;
    if (factors.size() == 2) return {factors[1], coefficient};
    const std::vector<Id> rest(factors.begin() + 1, factors.end());
    return {build(Op::Product, rest), coefficient};
}

Id Graph::scaled(Id rest, const Number& coefficient) {
    if (coefficient.zero()) return number(0);
    if (coefficient.one()) return rest;
    std::vector<Id> factors{number(coefficient)};
    if (nodes_[rest].op == Op::Product)
        std::ranges::copy(args(rest), std::back_inserter(factors));
    else
        factors.push_back(rest);
    return build(Op::Product, factors);
}

Id Graph::add(std::span<const Id> given) {
    Number constant = 0;
    std::vector<Term> terms;
    const auto take = [&](Id id) {
        if (is_number(id))
            constant = constant + nodes_[id].number;
        else
            terms.push_back(split_coefficient(id));
    };
    for (const Id id : given) {
        if (nodes_[id].op != Op::Sum) {
            take(id);
            continue;
        }
        const std::vector<Id> inner(args(id).begin(), args(id).end());
        for (const Id t : inner) take(t);
    }
    if (!constant.finite()) return undefined();

    std::ranges::stable_sort(terms, {}, &Term::rest);
    std::vector<Id> result;
    for (auto t = terms.begin(); t != terms.end();) {
        Number sum = 0;
        const Id rest = t->rest;
        for (; t != terms.end() && t->rest == rest; ++t) sum = sum + t->coefficient;
        if (!sum.finite()) return undefined();
        if (!sum.zero()) result.push_back(scaled(rest, sum));
    }
    sort_terms(result);
    if (!constant.zero()) result.push_back(number(constant));
    if (result.empty()) return number(0);
    return result.size() == 1 ? result[0] : build(Op::Sum, result);
}

Id Graph::distribute(const Number& coefficient, Id sum) {
    std::vector<Id> terms(args(sum).begin(), args(sum).end());
    for (Id& t : terms) {
        if (is_number(t)) {
            t = number(coefficient * nodes_[t].number);
            continue;
        }
        const Term term = split_coefficient(t);
        t = scaled(term.rest, coefficient * term.coefficient);
    }
    return add(terms);
}

Id Graph::multiply(std::span<const Id> given) {
    Number coefficient = 1;
    std::vector<Id> factors;
    const auto take = [&](Id id) {
        if (is_number(id))
            coefficient = coefficient * nodes_[id].number;
        else
            factors.push_back(id);
    };
    for (const Id id : given) {
        if (nodes_[id].op == Op::Product)
            std::ranges::for_each(args(id), take);
        else
            take(id);
    }
    if (!coefficient.finite()) return undefined();
    if (coefficient.zero()) return number(0);

    struct Based {
        Id base, factor;
    };
    std::vector<Based> by_base;
    by_base.reserve(factors.size());
    for (const Id f : factors) by_base.push_back({nodes_[f].op == Op::Power ? args(f)[0] : f, f});
    std::ranges::stable_sort(by_base, {}, &Based::base);

    std::vector<Id> result;
    bool again = false, merges = false;
    for (auto f = by_base.begin(); f != by_base.end();) {
        auto end = f;
        std::vector<Id> exponents;
        for (; end != by_base.end() && end->base == f->base; ++end)
            exponents.push_back(end->factor == end->base ? number(1) : args(end->factor)[1]);
        if (exponents.size() == 1) {
            result.push_back(f->factor);
        } else {
            merges = true;
            const Id merged = power(f->base, add(exponents));
            const bool same_base = merged == f->base || (nodes_[merged].op == Op::Power && args(merged)[0] == f->base);
            again = again || !same_base || is_number(merged);
            result.push_back(merged);
        }
        f = end;
    }
    if (again) {  // a power has become a number, several factors, or one of another base, as |x|² is x²
        result.push_back(number(coefficient));
        return multiply(result);
    }
    if (result.empty()) return number(coefficient);
    if (result.size() == 1 && coefficient.one()) return result[0];
    if (result.size() == 1 && nodes_[result[0]].op == Op::Sum) return distribute(coefficient, result[0]);
    if (!merges) result = factors;  // often in order already, as in a derivative's terms
    const auto before = [&](Id a, Id b) { return compare(a, b) < 0; };
    if (!std::ranges::is_sorted(result, before)) std::ranges::sort(result, before);
    if (!coefficient.one()) result.insert(result.begin(), number(coefficient));
    return build(Op::Product, result);
}

// Exact where the root is: 8^(1/3) = 2. Otherwise as 2^(3/2) = 2·2^(1/2): exponents between 0 and 1, integer bases.
Id Graph::number_power(const Number& base, const Number& exponent) {
    if (exponent.integer()) return number(integer_power(base, exponent));
    if (!exponent.exact() || !base.exact()) {
        const bool negative = base.negative();
        const double size = std::pow(std::abs(base.value()), exponent.value());
        return negative ? undefined() : number(Number::from_double(size));
    }
    const std::int64_t p = exponent.numerator(), q = exponent.denominator();
    if (base.negative() && q % 2 == 0) return undefined();
    Number coefficient = base.negative() && p % 2 != 0 ? -1 : 1;
    std::vector<Id> factors;
    const auto take = [&](std::int64_t integer, std::int64_t numerator) {  // integer^(numerator/q)
        if (integer == 1) return;
        if (const std::int64_t root = exact_root(integer, q); root >= 0) {
            coefficient = coefficient * integer_power(root, numerator);
            return;
        }
        const std::int64_t whole = numerator / q - (numerator % q < 0 ? 1 : 0);
        coefficient = coefficient * integer_power(integer, whole);
        factors.push_back(
            build(Op::Power, std::array{number(integer), number(Number::ratio(numerator - whole * q, q))}));
    };
    if (base.zero()) return p > 0 ? number(0) : undefined();
    take(std::abs(base.numerator()), p);
    take(base.denominator(), -p);
    if (!coefficient.exact())
        return number(Number::from_double((base.negative() && p % 2 != 0 ? -1.0 : 1.0) *
                                          std::pow(std::abs(base.value()), exponent.value())));
    factors.push_back(number(coefficient));
    return factors.size() == 1 ? factors[0] : multiply(factors);
}

Id Graph::power(Id base, Id exponent) {
    if (is_undefined(base) || is_undefined(exponent)) return undefined();
    const bool numeric = is_number(exponent);
    const Number e = numeric ? nodes_[exponent].number : Number(1);
    if (numeric && e.zero()) return number(1);
    if (numeric && e.one()) return base;
    if (is_number(base)) {
        const Number b = nodes_[base].number;
        if (numeric) return number_power(b, e);
        if (b.one()) return base;
    }
    const Op op = nodes_[base].op;
    if (op == Op::Euler && nodes_[exponent].op == Op::Log) return args(exponent)[0];
    if (op == Op::Power) {
        const Id inner = args(base)[0], inner_exponent = args(base)[1];
        const bool positive = nodes_[inner].constant && nodes_[inner].value > 0.0;
        // Real roots: (x³)^(1/2) is x^(3/2) and (x²)^(1/3) is x^(2/3), but (x²)^(1/2) is not x.
        const bool fractions = numeric && is_number(inner_exponent) && e.exact() &&
                               nodes_[inner_exponent].number.exact() &&
                               !(parity(nodes_[inner_exponent].number) == Parity::Even && parity(e) == Parity::None);
        if (positive || fractions || (numeric && e.integer()))
            return power(inner, multiply({inner_exponent, exponent}));
    }
    if (op == Op::Abs && numeric && e.even()) return power(args(base)[0], exponent);
    if (op == Op::Product && numeric && e.integer()) {
        std::vector<Id> factors(args(base).begin(), args(base).end());
        for (Id& f : factors) f = power(f, exponent);
        return multiply(factors);
    }
    return build(Op::Power, std::array{base, exponent});
}

// The function's value where it has a simple one, or kNone.
Id Graph::folded(Op function, std::span<const Id> given) {
    const Id a = given[0];
    const Op op = nodes_[a].op;
    const bool zero = is_number(a) && nodes_[a].number.zero();
    const auto pi_multiple = [&]() -> std::optional<Number> {  // c of c·π
        const Term t = split_coefficient(a);
        return nodes_[t.rest].op == Op::Pi ? std::optional(t.coefficient) : std::nullopt;
    };
    switch (function) {
        case Op::Log:
            if (is_number(a) && nodes_[a].number.one()) return number(0);
            if (op == Op::Euler) return number(1);
            if (op == Op::Power && nodes_[args(a)[0]].op == Op::Euler) return args(a)[1];
            return kNone;
        case Op::Sin:
        case Op::Cos:
        case Op::Tan: {
            if (zero) return number(function == Op::Cos ? 1 : 0);
            const auto multiple = pi_multiple();
            if (!multiple || !multiple->exact()) return kNone;
            const Number half_turns = *multiple * Number(2);  // in quarter turns
            if (!half_turns.integer()) return kNone;
            const auto quarter = (half_turns.numerator() % 4 + 4) % 4;
            if (function == Op::Tan) return quarter % 2 == 0 ? number(0) : undefined();
            constexpr std::array<std::int64_t, 5> kSines{0, 1, 0, -1, 0};
            return number(kSines[static_cast<std::size_t>(quarter) + (function == Op::Cos ? 1 : 0)]);
        }
        case Op::Asin:
        case Op::Atan:
        case Op::Sinh:
        case Op::Tanh:
        case Op::Asinh:
        case Op::Atanh: return zero ? a : kNone;
        case Op::Cosh: return zero ? number(1) : kNone;
        case Op::Acos:
        case Op::Acosh: return is_number(a) && nodes_[a].number.one() ? number(0) : kNone;
        case Op::Abs:
            if (is_number(a)) return nodes_[a].number.negative() ? negate(a) : a;
            if (op == Op::Abs) return a;
            if (op == Op::Power && is_number(args(a)[1]) && nodes_[args(a)[1]].number.even()) return a;
            return kNone;
        case Op::Sign: {
            if (!nodes_[a].constant) return kNone;
            const double v = nodes_[a].value;
            return number(v > 0.0 ? 1 : v < 0.0 ? -1 : 0);
        }
        case Op::Floor:
            if (nodes_[a].constant) return number(Number::from_double(std::floor(nodes_[a].value)));
            return op == Op::Floor ? a : kNone;
        case Op::Min:
        case Op::Max: {
            const Id b = given[1];
            if (a == b) return a;
            if (!nodes_[a].constant || !nodes_[b].constant) return kNone;
            return (nodes_[a].value <= nodes_[b].value) == (function == Op::Min) ? a : b;
        }
        case Op::Where:
            if (a == given[2]) return a;
            if (!nodes_[given[1]].constant) return kNone;
            return nodes_[given[1]].value <= 0.0 ? a : given[2];
        default: return kNone;
    }
}

Id Graph::apply(Op function, std::span<const Id> given) {
    const std::vector<Id> operands(given.begin(), given.end());
    if (std::ranges::any_of(operands, [&](Id a) { return is_undefined(a); })) return undefined();
    if (const Id value = folded(function, operands); value != kNone) return value;

    // sin(−u) = −sin(u), cos(−u) = cos(u), and so on
    const Number sign =
        is_number(operands[0]) ? nodes_[operands[0]].number : split_coefficient(operands[0]).coefficient;
    if (sign.negative()) {
        switch (function) {
            case Op::Cos:
            case Op::Cosh:
            case Op::Abs: return apply(function, {negate(operands[0])});
            case Op::Sin:
            case Op::Tan:
            case Op::Asin:
            case Op::Atan:
            case Op::Sinh:
            case Op::Tanh:
            case Op::Asinh:
            case Op::Atanh:
            case Op::Sign: return negate(apply(function, {negate(operands[0])}));
            default: break;
        }
    }
    return build(function, operands);
}

}  // namespace normalscope::formulas

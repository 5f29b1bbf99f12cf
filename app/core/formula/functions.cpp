#include "core/formula/functions.h"

#include "core/formula/syntax_error.h"

#include <array>

namespace normalscope::formulas {

namespace {

using Args = std::span<const Id>;

template <Op op>
Id of(Graph& g, Args args) {
    return g.apply(op, args);
}

// Of any number of arguments: two by two.
template <Op op>
Id folded(Graph& g, Args args) {
    Id result = args[0];
    for (const Id a : args.subspan(1)) result = g.apply(op, {result, a});
    return result;
}

template <Op op>
Id inverse(Graph& g, Args args) {
    return g.divide(g.number(1), g.apply(op, args));
}

template <int base>
Id logarithm(Graph& g, Args args) {
    return g.divide(g.apply(Op::Log, args), g.apply(Op::Log, {g.number(base)}));
}

Id exp(Graph& g, Id u) { return g.power(g.euler(), u); }
Id half(Graph& g) { return g.number(Number::ratio(1, 2)); }

Id hypot(Graph& g, Args args) {
    std::vector<Id> squares;
    for (const Id a : args) squares.push_back(g.power(a, g.number(2)));
    return g.sqrt(g.add(squares));
}

Id ceil(Graph& g, Args u) { return g.negate(g.apply(Op::Floor, {g.negate(u[0])})); }
// With the divisor's sign: mod(−1, 3) is 2.
Id mod(Graph& g, Args args) {
    return g.subtract(args[0], g.multiply({args[1], g.apply(Op::Floor, {g.divide(args[0], args[1])})}));
}
// 1/2 at the step itself.
Id heaviside(Graph& g, Args u) { return g.multiply({half(g), g.add({g.number(1), g.apply(Op::Sign, u)})}); }

constexpr std::size_t kAny = kMostCharacters;

constexpr std::array kFunctions{
    Function{"sqrt", 1, 1, [](Graph& g, Args u) { return g.sqrt(u[0]); }},
    Function{"cbrt", 1, 1, [](Graph& g, Args u) { return g.power(u[0], g.number(Number::ratio(1, 3))); }},
    Function{"exp", 1, 1, [](Graph& g, Args u) { return exp(g, u[0]); }},
    Function{"log", 1, 1, of<Op::Log>},
    Function{"ln", 1, 1, of<Op::Log>},
    Function{"log10", 1, 1, logarithm<10>},
    Function{"log2", 1, 1, logarithm<2>},
    Function{"pow", 2, 2, [](Graph& g, Args args) { return g.power(args[0], args[1]); }},
    Function{"sin", 1, 1, of<Op::Sin>},
    Function{"cos", 1, 1, of<Op::Cos>},
    Function{"tan", 1, 1, of<Op::Tan>},
    Function{"cot", 1, 1, inverse<Op::Tan>},
    Function{"sec", 1, 1, inverse<Op::Cos>},
    Function{"csc", 1, 1, inverse<Op::Sin>},
    Function{"asin", 1, 1, of<Op::Asin>},
    Function{"acos", 1, 1, of<Op::Acos>},
    Function{"atan", 1, 1, of<Op::Atan>},
    Function{"arcsin", 1, 1, of<Op::Asin>},
    Function{"arccos", 1, 1, of<Op::Acos>},
    Function{"arctan", 1, 1, of<Op::Atan>},
    Function{"atan2", 2, 2, of<Op::Atan2>},
    Function{"sinh", 1, 1, of<Op::Sinh>},
    Function{"cosh", 1, 1, of<Op::Cosh>},
    Function{"tanh", 1, 1, of<Op::Tanh>},
    Function{"asinh", 1, 1, of<Op::Asinh>},
    Function{"acosh", 1, 1, of<Op::Acosh>},
    Function{"atanh", 1, 1, of<Op::Atanh>},
    Function{"hypot", 2, kAny, hypot},
    Function{"abs", 1, 1, of<Op::Abs>},
    Function{"sign", 1, 1, of<Op::Sign>},
    Function{"floor", 1, 1, of<Op::Floor>},
    Function{"ceil", 1, 1, ceil},
    Function{"mod", 2, 2, mod},
    Function{"heaviside", 1, 1, heaviside},
    Function{"min", 2, kAny, folded<Op::Min>},
    Function{"max", 2, kAny, folded<Op::Max>},
    Function{"where", 3, 3, of<Op::Where>},
};

}  // namespace

std::span<const Function> functions() { return kFunctions; }

std::string known_functions() {
    std::string names;
    for (const Function& f : kFunctions) names += (names.empty() ? "" : " ") + std::string(f.name);
    return names;
}

}  // namespace normalscope::formulas

#include "core/formula/graph.h"

#include <algorithm>

namespace normalscope::formulas {

namespace {

// f(u)' / u' for the functions of one argument.
Id outer_derivative(Graph& g, Op function, Id node, Id u) {
    const Id one = g.number(1), minus_two = g.number(-2);
    const auto root_of_one_minus_square = [&] {
        return g.power(g.subtract(one, g.power(u, g.number(2))), g.number(Number::ratio(-1, 2)));
    };
    const auto root_of_square_plus = [&](int constant) {
        return g.power(g.add({g.power(u, g.number(2)), g.number(constant)}), g.number(Number::ratio(-1, 2)));
    };
    switch (function) {
        case Op::Log: return g.power(u, g.number(-1));
        case Op::Sin: return g.apply(Op::Cos, {u});
        case Op::Cos: return g.negate(g.apply(Op::Sin, {u}));
        case Op::Tan: return g.power(g.apply(Op::Cos, {u}), minus_two);
        case Op::Asin: return root_of_one_minus_square();
        case Op::Acos: return g.negate(root_of_one_minus_square());
        case Op::Atan: return g.power(g.add({one, g.power(u, g.number(2))}), g.number(-1));
        case Op::Sinh: return g.apply(Op::Cosh, {u});
        case Op::Cosh: return g.apply(Op::Sinh, {u});
        case Op::Tanh: return g.power(g.apply(Op::Cosh, {u}), minus_two);
        case Op::Asinh: return root_of_square_plus(1);
        case Op::Acosh: return root_of_square_plus(-1);
        case Op::Atanh: return g.power(g.subtract(one, g.power(u, g.number(2))), g.number(-1));
        case Op::Abs: return g.apply(Op::Sign, {u});
        default: return node == u ? one : g.number(0);  // sign and floor: flat wherever they have a derivative
    }
}

Id power_derivative(Graph& g, Id node, Id base, Id exponent, Id d_base, Id d_exponent) {
    std::vector<Id> terms;
    const Id zero = g.number(0);
    if (d_base != zero) terms.push_back(g.multiply({exponent, g.power(base, g.add({exponent, g.number(-1)})), d_base}));
    if (d_exponent != zero && base != zero)  // 0^u is 0 wherever it has a value around
        terms.push_back(g.multiply({node, g.apply(Op::Log, {base}), d_exponent}));
    return g.add(terms);
}

}  // namespace

Id derivative(Graph& g, Id root, int variable) {
    const std::vector<bool> reached = reachable(g, root);
    const Id zero = g.number(0), one = g.number(1);
    std::vector<Id> d(root + 1, zero);
    std::vector<Id> args, terms;
    for (Id id = 0; id <= root; ++id) {  // operands come before what is made of them
        if (!reached[id] || g[id].constant) continue;
        args.assign(g.args(id).begin(), g.args(id).end());
        const Op op = g[id].op;
        terms.clear();
        switch (op) {
            case Op::Parameter: break;
            case Op::Variable: d[id] = g[id].index == variable ? one : zero; break;
            case Op::Sum:
                for (const Id a : args)
                    if (d[a] != zero) terms.push_back(d[a]);
                d[id] = g.add(terms);
                break;
            case Op::Product:
                for (std::size_t i = 0; i < args.size(); ++i) {
                    if (d[args[i]] == zero) continue;
                    std::vector<Id> factors = args;
                    factors[i] = d[args[i]];
                    terms.push_back(g.multiply(factors));
                }
                d[id] = g.add(terms);
                break;
            case Op::Power: d[id] = power_derivative(g, id, args[0], args[1], d[args[0]], d[args[1]]); break;
            case Op::Min: d[id] = g.apply(Op::Where, {d[args[0]], g.subtract(args[0], args[1]), d[args[1]]}); break;
            case Op::Max: d[id] = g.apply(Op::Where, {d[args[0]], g.subtract(args[1], args[0]), d[args[1]]}); break;
            case Op::Atan2: {
                const Id turn = g.subtract(g.multiply({args[1], d[args[0]]}), g.multiply({args[0], d[args[1]]}));
                const Id square = g.add({g.power(args[0], g.number(2)), g.power(args[1], g.number(2))});
                if (turn != zero) d[id] = g.divide(turn, square);
                break;
            }
            case Op::Where: d[id] = g.apply(Op::Where, {d[args[0]], args[1], d[args[2]]}); break;
            default:
                if (d[args[0]] != zero) d[id] = g.multiply({outer_derivative(g, op, id, args[0]), d[args[0]]});
        }
    }
    return d[root];
}

}  // namespace normalscope::formulas

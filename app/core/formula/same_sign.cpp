#include "core/formula/same_sign.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace normalscope::formulas {

namespace {

constexpr double kHighPower = 20.0;           // beyond it u^n leaves a float's range near u = 0.01 or 100
constexpr double kLeast = 1e-6, kMost = 1e6;  // what a factor may be before it is left out
constexpr int kDeepest = 60;                  // expressions may be nested more deeply than the machine's stack is

class Tamer {
public:
    explicit Tamer(Graph& graph) : g_(graph) {}

    Id tamed(Id id, int depth = 0) {
        if (depth > kDeepest) return id;
        switch (g_[id].op) {
            case Op::Product: return product(id, depth + 1);
            case Op::Power: return power(id, depth + 1);
            case Op::Sum: return sum(id, depth + 1);
            default: return id;
        }
    }

private:
    std::vector<Id> args(Id id) const { return {g_.args(id).begin(), g_.args(id).end()}; }

    /// The exponent of a power by a whole number, greater than 0.
    std::optional<Number> whole_exponent(Id id) const {
        if (g_[id].op != Op::Power || !g_.is_number(g_.args(id)[1])) return std::nullopt;
        const Number n = g_[g_.args(id)[1]].number;
        return n.integer() && n.value() > 0.0 ? std::optional(n) : std::nullopt;
    }
    bool is_exp(Id id) const { return g_[id].op == Op::Power && g_[g_.args(id)[0]].op == Op::Euler; }

    Id product(Id id, int depth) {
        std::vector<Id> factors;
        bool changed = false;
        for (const Id factor : args(id)) {
            const double size = std::abs(g_[factor].value);
            Id tame = factor;
            if (!g_[factor].constant)
                tame = tamed(factor, depth);
            else if (size > 0.0 && (size < kLeast || size > kMost))
                tame = g_.number(g_[factor].value < 0.0 ? -1 : 1);
            changed = changed || tame != factor;
            factors.push_back(tame);
        }
        return changed ? g_.multiply(factors) : id;
    }

    // As u² or u³: they touch and cross zero as u^n does, with ∇f = 0.
    Id power(Id id, int depth) {
        const auto n = whole_exponent(id);
        if (!n || n->value() <= kHighPower) return id;
        return g_.power(tamed(g_.args(id)[0], depth), g_.number(n->even() ? 2 : 3));
    }

    // ---- sums: A − B, where both are positive or odd powers ----------------------------------------------------------

    struct Term {
        bool negative;
        Id rest;  ///< without its sign
    };
    Term signed_term(Id id) {
        if (g_[id].constant) return g_[id].value < 0.0 ? Term{true, g_.negate(id)} : Term{false, id};
        if (g_[id].op == Op::Product && g_[g_.args(id)[0]].constant && g_[g_.args(id)[0]].value < 0.0)
            return {true, g_.negate(id)};
        return {false, id};
    }

    /// ln A of what is positive but for zeros: constants, exponentials, even powers, and their products.
    struct Logarithm {
        std::vector<Id> terms;
        bool extreme = false;  ///< there is an exponential or a high power
    };
    bool add_logarithm(Id id, Logarithm& log) {
        if (g_[id].op == Op::Product) {
            const std::vector<Id> factors = args(id);
            return std::ranges::all_of(factors, [&](Id factor) { return add_logarithm(factor, log); });
        }
        if (g_[id].constant) {
            if (!(g_[id].value > 0.0) || !std::isfinite(g_[id].value)) return false;
            log.terms.push_back(g_.apply(Op::Log, {id}));
            return true;
        }
        if (is_exp(id)) {
            log.terms.push_back(g_.args(id)[1]);
            return log.extreme = true;
        }
        const auto n = whole_exponent(id);
        if (!n || !n->even()) return false;
        const Id size = g_.apply(Op::Abs, {g_.args(id)[0]});
        log.terms.push_back(g_.multiply({g_.number(*n), g_.apply(Op::Log, {size})}));
        log.extreme = log.extreme || n->value() > kHighPower;
        return true;
    }

    Id root_of(Id constant, const Number& n) { return g_.power(constant, g_.power(g_.number(n), g_.number(-1))); }

    /// The n-th root of a term: u or |u| of u^n, of positive numbers, and of products of these.
    std::optional<Id> root(Id term, const Number& n) {
        if (g_[term].constant)
            return g_[term].value > 0.0 && std::isfinite(g_[term].value) ? std::optional(root_of(term, n))
                                                                         : std::nullopt;
        if (g_[term].op == Op::Product) {
            std::vector<Id> roots;
            for (const Id factor : args(term)) {
                const auto one = g_[factor].op == Op::Product ? std::nullopt : root(factor, n);
                if (!one) return std::nullopt;
                roots.push_back(*one);
            }
            return g_.multiply(roots);
        }
        if (whole_exponent(term) != n) return std::nullopt;
        const Id base = g_.args(term)[0];
        return n.even() ? g_.apply(Op::Abs, {base}) : base;
    }
    /// The one exponent that all of a term may have.
    std::optional<Number> high_exponent(Id term) const {
        std::optional<Number> n = whole_exponent(term);
        if (g_[term].op == Op::Product)
            for (const Id factor : g_.args(term))
                if (const auto one = whole_exponent(factor)) n = one;
        return n && n->value() > kHighPower ? n : std::nullopt;
    }

    double coefficient(Id term) const {
        const Id first = g_[term].op == Op::Product ? g_.args(term)[0] : term;
        return g_[first].constant ? std::abs(g_[first].value) : 1.0;
    }

    Id sum(Id id, int depth) {
        const std::vector<Id> terms = args(id);
        if (terms.size() == 2) {
            if (const auto tame = of_two(terms[0], terms[1], depth)) return *tame;
            if (const auto tame = of_hyperbolic(terms[0], terms[1], depth)) return *tame;
        }
        double largest = 0.0;
        for (const Id term : terms) largest = std::max(largest, coefficient(term));
        if ((largest > 0.0 && largest < kLeast) || (largest > kMost && std::isfinite(largest)))
            return tamed(
                g_.multiply(
                    {g_.number(Number::from_double(std::exp2(std::clamp(-std::ilogb(largest), -1000, 1000)))), id}),
                depth);
        // Even powers that are added, or all subtracted, are 0 together.
        std::vector<Id> tame_terms;
        for (const Id term : terms) {
            const Term part = signed_term(term);
            Logarithm log;
            if (part.negative != signed_term(terms[0]).negative || !add_logarithm(part.rest, log)) return id;
            tame_terms.push_back(tamed(term, depth));
        }
        return tame_terms == terms ? id : g_.add(tame_terms);
    }
    std::optional<Id> of_two(Id first, Id second, int depth) {
        const Term a = signed_term(first), b = signed_term(second);
        const Id up = a.negative ? b.rest : a.rest, down = a.negative ? a.rest : b.rest;
        if (const auto n = high_exponent(g_[first].constant ? second : first)) {
            const auto u = root(up, *n), v = root(down, *n);
            if (u && v && a.negative != b.negative) return tamed(g_.subtract(*u, *v), depth);
            if (u && v && !n->even()) {
                const Id both = g_.add({*u, *v});
                return tamed(a.negative ? g_.negate(both) : both, depth);
            }
        }
        Logarithm above, below;
        if (a.negative == b.negative || !add_logarithm(up, above) || !add_logarithm(down, below) ||
            !(above.extreme || below.extreme))
            return std::nullopt;
        return tamed(g_.subtract(g_.add(above.terms), g_.add(below.terms)), depth);
    }

    // k sinh(u) + c or k cosh(u) + c, where c/k is beyond what floats compare well: as u against the constant's area.
    std::optional<Id> of_hyperbolic(Id varying, Id constant, int depth) {
        const std::vector<Id> factors =
            g_[varying].op == Op::Product ? args(varying) : std::vector{g_.number(1), varying};
        if (factors.size() != 2 || !g_[constant].constant || !g_[factors[0]].constant) return std::nullopt;
        const Id level = g_.negate(g_.divide(constant, factors[0]));
        const Op op = g_[factors[1]].op;
        if (!(std::abs(g_[level].value) > kMost) || !std::isfinite(g_[level].value)) return std::nullopt;
        if (op != Op::Sinh && !(op == Op::Cosh && g_[level].value > 0.0)) return std::nullopt;
        const Id u = args(factors[1])[0];
        const Id tame = op == Op::Sinh ? g_.subtract(u, g_.apply(Op::Asinh, {level}))
                                       : g_.subtract(g_.apply(Op::Abs, {u}), g_.apply(Op::Acosh, {level}));
        return tamed(g_[factors[0]].value < 0.0 ? g_.negate(tame) : tame, depth);
    }

    Graph& g_;
};

}  // namespace

Id same_sign(Graph& graph, Id root) { return Tamer(graph).tamed(root); }

}  // namespace normalscope::formulas

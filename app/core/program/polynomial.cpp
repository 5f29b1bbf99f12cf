#include "core/program/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope::formulas {

namespace {

constexpr std::size_t kMostProducts = 4'000'000;  // of terms; about a second

void add_term(Polynomial& p, const Polynomial::Exponents& e, const Number& c) {
    const auto [at, inserted] = p.terms.try_emplace(e, c);
    if (!inserted) at->second = at->second + c;
    if (at->second.zero()) p.terms.erase(at);
}

Polynomial constant(const Number& n, bool exact) {
    Polynomial p;
    p.exact = exact;
    if (!n.zero()) p.terms.emplace(Polynomial::Exponents{}, n);
    return p;
}

// Multiplies within a budget; what goes beyond it is no polynomial that anyone wants multiplied out.
struct Multiplier {
    std::size_t products = 0;

    std::optional<Polynomial> operator()(const Polynomial& a, const Polynomial& b) {
        products += a.terms.size() * b.terms.size();
        if (a.degree() + b.degree() > kMostDegree || products > kMostProducts) return std::nullopt;
        Polynomial result;
        result.exact = a.exact && b.exact;
        for (const auto& [e, c] : a.terms)
            for (const auto& [f, d] : b.terms) add_term(result, {e[0] + f[0], e[1] + f[1], e[2] + f[2]}, c * d);
        return result;
    }
};

double norm(const RayPolynomial& p) {
    double sum = 0.0;
    for (int k = 0; k <= p.degree; ++k) sum += std::abs(p.c[static_cast<std::size_t>(k)]);
    return sum;
}

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

RayPolynomial sum(const RayPolynomial& a, const RayPolynomial& b, double sign) {
    RayPolynomial r;
    r.degree = std::max(a.degree, b.degree);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(r.degree); ++k) r.c[k] = a.c[k] + sign * b.c[k];
    r.noise = a.noise + b.noise + kEpsilon * norm(r);
    return r;
}

RayPolynomial product(const RayPolynomial& a, const RayPolynomial& b) {
    RayPolynomial r;
    r.degree = a.degree + b.degree;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(a.degree); ++i)
        for (std::size_t j = 0; j <= static_cast<std::size_t>(b.degree); ++j) r.c[i + j] += a.c[i] * b.c[j];
    const double m = norm(a), n = norm(b);
    r.noise = a.noise * (n + b.noise) + b.noise * m + kEpsilon * (std::min(a.degree, b.degree) + 1) * m * n;
    return r;
}

}  // namespace

int Polynomial::degree() const {
    int most = 0;
    for (const auto& [e, c] : terms) most = std::max(most, e[0] + e[1] + e[2]);
    return most;
}

std::optional<Polynomial> polynomial(const Graph& graph, Id root, const std::optional<Parameters>& parameters) {
    const std::vector<bool> reached = reachable(graph, root);
    std::vector<Polynomial> values(root + 1);
    Multiplier multiply;
    for (Id id = 0; id <= root; ++id) {
        if (!reached[id]) continue;
        const Node& node = graph[id];
        const std::span<const Id> args = graph.args(id);
        Polynomial& p = values[id];
        if (graph.is_number(id)) {
            if (!node.number.finite()) return std::nullopt;
            p = constant(node.number, node.number.exact());
        } else if (node.constant) {
            p = constant(Number::from_double(node.value), false);
        } else if (node.op == Op::Parameter) {
            if (!parameters) return std::nullopt;
            p = constant(Number::from_double((*parameters)[node.index]), true);
        } else if (node.op == Op::Variable) {
            Polynomial::Exponents e{};
            e[node.index] = 1;
            p.terms.emplace(e, 1);
        } else if (node.op == Op::Sum) {
            for (const Id a : args) {
                for (const auto& [e, c] : values[a].terms) add_term(p, e, c);
                p.exact = p.exact && values[a].exact;
            }
        } else if (node.op == Op::Product) {
            p = constant(1, true);
            for (const Id a : args) {
                auto next = multiply(p, values[a]);
                if (!next) return std::nullopt;
                p = std::move(*next);
            }
        } else if (node.op == Op::Power) {
            const Polynomial& exponent = values[args[1]];
            const Number n = exponent.terms.empty() ? Number(0) : exponent.terms.begin()->second;
            if (exponent.degree() > 0 || !n.integer() || n.negative() || n.value() > kMostDegree) return std::nullopt;
            p = constant(1, exponent.exact);
            for (int i = 0; i < static_cast<int>(n.value()); ++i) {
                auto next = multiply(p, values[args[0]]);
                if (!next) return std::nullopt;
                p = std::move(*next);
            }
        } else {
            return std::nullopt;
        }
    }
    const bool finite = std::ranges::all_of(values[root].terms, [](const auto& t) { return t.second.finite(); });
    return finite ? std::optional(std::move(values[root])) : std::nullopt;
}

std::optional<RayPolynomial> along_ray(const Program& program, glm::dvec3 o, glm::dvec3 d) {
    if (!polynomial_degree(program, kMostDegree)) return std::nullopt;
    std::vector<RayPolynomial> values(program.size());
    for (std::size_t k = 0; k < program.size(); ++k) {
        const Instruction& i = program[k];
        RayPolynomial& r = values[k];
        switch (i.code) {
            case Code::Variable: {
                const auto axis = static_cast<glm::length_t>(i.a);
                r.c[0] = o[axis];
                r.c[1] = d[axis];
                r.degree = 1;
                break;
            }
            case Code::Add: r = sum(values[i.a], values[i.b], 1.0); break;
            case Code::Subtract: r = sum(values[i.a], values[i.b], -1.0); break;
            case Code::Multiply: r = product(values[i.a], values[i.b]); break;
            case Code::Divide: {
                RayPolynomial reciprocal;
                reciprocal.c[0] = 1.0 / values[i.b].c[0];
                reciprocal.noise = kEpsilon * std::abs(reciprocal.c[0]);
                r = product(values[i.a], reciprocal);
                break;
            }
            case Code::Negate:
                r = values[i.a];
                for (double& c : r.c) c = -c;
                break;
            case Code::IntegerPower: {
                RayPolynomial square = values[i.a];
                r.c[0] = 1.0;
                bool first = true;
                for (auto n = static_cast<unsigned>(i.constant); n != 0; n >>= 1) {
                    if (n & 1) r = first ? square : product(r, square);
                    first = first && !(n & 1);
                    if (n > 1) square = product(square, square);
                }
                break;
            }
            default: r.c[0] = i.constant; r.noise = kEpsilon * std::abs(i.constant);
        }
    }
    for (const double c : values.back().c)
        if (!std::isfinite(c)) return std::nullopt;
    return values.back();
}

}  // namespace normalscope::formulas

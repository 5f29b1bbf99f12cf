#include "core/formula/graph.h"

#include <algorithm>
#include <array>
#include <compare>

namespace normalscope::formulas {

namespace {

struct Based {
    Id base;
    Number exponent;
    bool symbolic;  // the exponent is no number
};

Based based(const Graph& g, Id id) {
    if (g[id].op != Op::Power) return {id, 1, false};
    const Id exponent = g.args(id)[1];
    if (!g.is_number(exponent)) return {g.args(id)[0], 1, true};
    return {g.args(id)[0], g[exponent].number, false};
}

int three_way(double a, double b) { return a < b ? -1 : a > b ? 1 : 0; }

// The exponents of x, y and z among a term's factors.
std::array<double, 3> exponents(const Graph& g, Id term) {
    std::array<double, 3> result{};
    const auto count = [&](Id factor) {
        const Based b = based(g, factor);
        if (g[b.base].op == Op::Variable && !b.symbolic) result[g[b.base].index] = b.exponent.value();
    };
    if (g[term].op == Op::Product)
        std::ranges::for_each(g.args(term), count);
    else
        count(term);
    return result;
}

}  // namespace

std::uint8_t Graph::rank(const Node& node, std::span<const Id> args) const {
    switch (node.op) {
        case Op::Number: return 0;
        case Op::Pi:
        case Op::Euler: return 1;
        case Op::Parameter: return 3;
        case Op::Variable: return 4;
        case Op::Sum: return node.constant ? 2 : 5;
        case Op::Power: return nodes_[args[0]].constant && !node.constant ? 7 : nodes_[args[0]].rank;  // 7: e^x
        default: return node.constant ? 2 : 6;
    }
}

int Graph::compare(Id a, Id b) const {
    // Equal parts have equal ids, so at every level only the first pair that differs matters: a loop, whatever the depth.
    while (a != b) {
        const Node &m = nodes_[a], &n = nodes_[b];
        if (m.rank != n.rank) return m.rank - n.rank;
        const Based p = based(*this, a), q = based(*this, b);
        const bool same_base = p.base == q.base;
        if (same_base && p.symbolic != q.symbolic) return p.symbolic ? 1 : -1;
        if (same_base && !p.symbolic) return three_way(q.exponent.value(), p.exponent.value());
        // The short one first. It also keeps deep nestings, whose parts have all different weights, from being walked.
        const Id s = same_base ? args(a)[1] : p.base, t = same_base ? args(b)[1] : q.base;
        if (nodes_[s].weight != nodes_[t].weight) return nodes_[s].weight < nodes_[t].weight ? -1 : 1;
        if (s != a || t != b) {
            a = s;
            b = t;
            continue;
        }
        if (m.op != n.op) return m.op < n.op ? -1 : 1;
        if (m.op == Op::Number) return three_way(m.value, n.value);
        if (m.index != n.index) return m.index < n.index ? -1 : 1;
        const std::span<const Id> u = args(a), v = args(b);
        const auto [i, j] = std::ranges::mismatch(u, v);
        if (i == u.end() || j == v.end()) return i == u.end() ? -1 : 1;
        a = *i;
        b = *j;
    }
    return 0;
}

// x² before xy before y², before x, before sin x, before 1.
void Graph::sort_terms(std::vector<Id>& terms) const {
    struct Key {
        double degree;
        std::array<double, 3> exponents;
        Id id;
    };
    std::vector<Key> keys;
    keys.reserve(terms.size());
    for (const Id t : terms) keys.push_back({nodes_[t].degree, exponents(*this, t), t});
    std::ranges::sort(keys, [&](const Key& a, const Key& b) {
        if (a.degree != b.degree) return a.degree > b.degree;
        if (a.exponents != b.exponents) return a.exponents > b.exponents;
        // Coefficients do not count: like terms have been collected.
        const Id s = a.id, t = b.id;
        const bool u = nodes_[s].op == Op::Product, v = nodes_[t].op == Op::Product;
        const std::span<const Id> p = u ? args(s) : std::span(&a.id, 1), q = v ? args(t) : std::span(&b.id, 1);
        const auto rest_p = p.subspan(u && is_number(p[0]) ? 1 : 0), rest_q = q.subspan(v && is_number(q[0]) ? 1 : 0);
        const auto [i, j] = std::ranges::mismatch(rest_p, rest_q);
        if (i == rest_p.end() || j == rest_q.end()) return i == rest_p.end() && j != rest_q.end();
        return compare(*i, *j) < 0;
    });
    std::ranges::transform(keys, terms.begin(), &Key::id);
}

}  // namespace normalscope::formulas

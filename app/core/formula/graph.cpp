#include "core/formula/graph.h"

#include "core/base/error.h"
#include "core/formula/real.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace normalscope::formulas {

namespace {

// Ten thousand characters with their derivatives stay well below; no picture is worth more memory.
constexpr std::size_t kMostArgs = 1 << 25;

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {  // splitmix64's steps
    hash = (hash ^ value) * 0xBF58476D1CE4E5B9u;
    return hash ^ hash >> 31;
}

}  // namespace

Id Graph::number(const Number& n) {
    Node node;
    node.number = n.finite() ? n : Number::from_double(std::numeric_limits<double>::quiet_NaN());
    node.value = node.number.value();
    return intern(node, {});
}

Id Graph::undefined() { return number(Number::from_double(std::numeric_limits<double>::quiet_NaN())); }

Id Graph::leaf(Op op, int index) {
    Node node;
    node.op = op;
    node.index = static_cast<std::uint8_t>(index);
    node.constant = op == Op::Pi || op == Op::Euler;
    if (op == Op::Pi) node.value = std::numbers::pi;
    if (op == Op::Euler) node.value = std::numbers::e;
    node.degree = op == Op::Variable ? 1.0 : 0.0;
    node.rank = rank(node, {});
    return intern(node, {});
}

Id Graph::build(Op op, std::span<const Id> args) {
    Node node;
    node.op = op;
    node.constant = std::ranges::all_of(args, [&](Id a) { return nodes_[a].constant; });
    if (node.constant) {
        node.value = constant_value(op, args);
        if (!std::isfinite(node.value)) return undefined();
        // π^−1000 is zero to doubles; written as 1/π^1000 it would overflow.
        if (op == Op::Power && std::abs(node.value) < 4.0 * std::numeric_limits<double>::min()) return number(0);
    }
    node.degree = std::clamp(degree(op, args), -1e9, 1e9);
    for (const Id a : args) node.weight = std::min(node.weight + nodes_[a].weight, 1e300);
    node.rank = rank(node, args);
    return intern(node, args);
}

// The node of this content; a new one only where there is none yet.
Id Graph::intern(Node node, std::span<const Id> args) {
    std::uint64_t hash = mix(static_cast<std::uint64_t>(node.op), node.index);
    if (node.op == Op::Number) hash = mix(hash, std::bit_cast<std::uint64_t>(node.value));
    for (const Id a : args) hash = mix(hash, a);

    if (2 * nodes_.size() >= table_.size()) grow_table();
    auto slot = static_cast<std::size_t>(hash & (table_.size() - 1));
    for (; table_[slot] != kNone; slot = (slot + 1) & (table_.size() - 1)) {
        const Id id = table_[slot];
        const Node& other = nodes_[id];
        if (hashes_[id] == hash && other.op == node.op && other.index == node.index && other.number == node.number &&
            std::ranges::equal(this->args(id), args))
            return id;
    }
    if (args_.size() + args.size() > kMostArgs)
        throw InputError("the formula or its derivative is too long; shorten it");
    node.first_arg = static_cast<std::uint32_t>(args_.size());
    node.arg_count = static_cast<std::uint32_t>(args.size());
    args_.insert(args_.end(), args.begin(), args.end());
    const Id id = size();
    table_[slot] = id;
    nodes_.push_back(node);
    hashes_.push_back(hash);
    return id;
}

void Graph::grow_table() {
    table_.assign(std::bit_ceil(4 * nodes_.size() + 64), kNone);
    for (Id id = 0; id < size(); ++id) {
        auto slot = static_cast<std::size_t>(hashes_[id] & (table_.size() - 1));
        while (table_[slot] != kNone) slot = (slot + 1) & (table_.size() - 1);
        table_[slot] = id;
    }
}

double Graph::constant_value(Op op, std::span<const Id> args) const {
    const auto value = [&](std::size_t i) { return nodes_[args[i]].value; };
    double result = op == Op::Product ? 1.0 : 0.0;
    switch (op) {
        case Op::Sum:
            for (const Id a : args) result += nodes_[a].value;
            return result;
        case Op::Product:
            for (const Id a : args) result *= nodes_[a].value;
            return result;
        case Op::Power: {
            const Number& exponent = nodes_[args[1]].number;
            if (!is_number(args[1])) return real::power(value(0), value(1));
            return real::power(value(0), exponent.value(), parity(exponent));
        }
        case Op::Log: return value(0) > 0.0 ? std::log(value(0)) : std::numeric_limits<double>::quiet_NaN();
        case Op::Sin: return std::sin(value(0));
        case Op::Cos: return std::cos(value(0));
        case Op::Tan: return std::tan(value(0));
        case Op::Asin: return std::asin(value(0));
        case Op::Acos: return std::acos(value(0));
        case Op::Atan: return std::atan(value(0));
        case Op::Sinh: return std::sinh(value(0));
        case Op::Cosh: return std::cosh(value(0));
        case Op::Tanh: return std::tanh(value(0));
        case Op::Asinh: return std::asinh(value(0));
        case Op::Acosh: return std::acosh(value(0));
        case Op::Atanh: return std::atanh(value(0));
        case Op::Abs: return std::abs(value(0));
        case Op::Sign: return real::sign(value(0));
        case Op::Floor: return std::floor(value(0));
        case Op::Min: return std::min(value(0), value(1));
        case Op::Max: return std::max(value(0), value(1));
        case Op::Atan2: return real::atan2(value(0), value(1));
        case Op::Where: return value(1) <= 0.0 ? value(0) : value(2);
        default: return nodes_[args[0]].value;
    }
}

double Graph::degree(Op op, std::span<const Id> args) const {
    double result = op == Op::Sum ? -std::numeric_limits<double>::infinity() : 0.0;
    bool varies = false;
    for (const Id a : args) {
        const double d = nodes_[a].degree;
        varies = varies || d != 0.0;
        if (op == Op::Sum) result = std::max(result, d);
        if (op == Op::Product) result += d;
    }
    if (op == Op::Sum || op == Op::Product) return result;
    if (op == Op::Power && is_number(args[1])) return nodes_[args[0]].degree * nodes_[args[1]].value;
    return varies ? 0.5 : 0.0;  // functions come between x and the constants
}

std::vector<bool> reachable(const Graph& graph, Id root) {
    std::vector<bool> reached(root + 1, false);
    reached[root] = true;
    for (Id id = root + 1; id-- > 0;)
        if (reached[id])
            for (const Id a : graph.args(id)) reached[a] = true;
    return reached;
}

std::string parameters_of(const Graph& graph, Id root) {
    const std::vector<bool> reached = reachable(graph, root);
    std::string letters;
    for (Id id = 0; id <= root; ++id)
        if (reached[id] && graph[id].op == Op::Parameter) letters += kParameterNames[graph[id].index];
    std::ranges::sort(letters);
    return letters;
}

Id copy(Graph& to, const Graph& from, Id root) {
    const std::vector<bool> reached = reachable(from, root);
    std::vector<Id> copies(root + 1);
    std::vector<Id> args;
    for (Id id = 0; id <= root; ++id) {
        if (!reached[id]) continue;
        args.clear();
        for (const Id a : from.args(id)) args.push_back(copies[a]);
        copies[id] = to.intern(from[id], args);  // it is in canonical order already, which does not depend on ids
    }
    return copies[root];
}

std::string_view function_name(Op op) {
    switch (op) {
        case Op::Log: return "log";
        case Op::Sin: return "sin";
        case Op::Cos: return "cos";
        case Op::Tan: return "tan";
        case Op::Asin: return "asin";
        case Op::Acos: return "acos";
        case Op::Atan: return "atan";
        case Op::Sinh: return "sinh";
        case Op::Cosh: return "cosh";
        case Op::Tanh: return "tanh";
        case Op::Asinh: return "asinh";
        case Op::Acosh: return "acosh";
        case Op::Atanh: return "atanh";
        case Op::Abs: return "abs";
        case Op::Sign: return "sign";
        case Op::Floor: return "floor";
        case Op::Min: return "min";
        case Op::Max: return "max";
        case Op::Atan2: return "atan2";
        case Op::Where: return "where";
        default: return {};
    }
}

}  // namespace normalscope::formulas

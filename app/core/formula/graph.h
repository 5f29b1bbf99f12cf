#pragma once

#include "core/formula/number.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace normalscope::formulas {

/// A node of a Graph. Equal ids mean equal expressions, and an operand's id is smaller than that of what uses it: so
/// every walk is a loop over ids, and no nesting is too deep.
using Id = std::uint32_t;

enum class Op : std::uint8_t {
    Number,
    Pi,
    Euler,      // e; exp(u) is Power(e, u)
    Parameter,  // index 0 … 6: a b c d f g h
    Variable,   // index 0 … 2: x y z
    Sum,        // of terms, the number last
    Product,    // of factors, the number first; quotients are powers with a negative exponent
    Power,      // sqrt(u) is Power(u, 1/2)
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
    Atan2,  // (y, x)
    Where,  // (a, c, b): a where c ≤ 0, else b; the derivative of min and max
};

inline constexpr std::string_view kVariableNames = "xyz";
inline constexpr std::string_view kParameterNames = "abcdfgh";  ///< e is Euler's number

/// The values of the parameters, in the order of kParameterNames.
using Parameters = std::array<double, kParameterNames.size()>;
inline constexpr Parameters kAllOne{1, 1, 1, 1, 1, 1, 1};

struct Node {
    Op op = Op::Number;
    std::uint8_t index = 0;
    bool constant = true;  ///< contains neither variables nor parameters
    std::uint32_t first_arg = 0, arg_count = 0;
    Number number;          ///< of Op::Number
    double value = 0.0;     ///< of a constant
    std::uint8_t rank = 0;  ///< constants, parameters, x y z, brackets, functions: as one writes factors
    double weight = 1.0;    ///< how many signs it would take to write it, about
    double degree = 0.0;    ///< in x, y, z; a guess for what is not a polynomial, to put terms in order
};

/// Expressions as an acyclic graph in which nothing is there twice. Nodes never change; what is built is simplified as
/// far as one reads easily: exact fractions, like terms and powers collected, canonical order; products of sums are
/// left as they are. Simplified and original agree wherever both have a value: x/x is 1.
class Graph {
public:
    Id number(const Number& n);
    Id pi() { return leaf(Op::Pi, 0); }
    Id euler() { return leaf(Op::Euler, 0); }
    Id variable(int index) { return leaf(Op::Variable, index); }
    Id parameter(int index) { return leaf(Op::Parameter, index); }
    Id undefined();  ///< what has no real value, such as 1/0

    // An exponent that is a fraction p/q with odd q is a real root: (−8)^(1/3) is −2.
    Id add(std::span<const Id> terms);
    Id multiply(std::span<const Id> factors);
    Id power(Id base, Id exponent);
    Id apply(Op function, std::span<const Id> args);

    Id add(std::initializer_list<Id> terms) { return add(std::span(terms.begin(), terms.size())); }
    Id multiply(std::initializer_list<Id> factors) { return multiply(std::span(factors.begin(), factors.size())); }
    Id apply(Op function, std::initializer_list<Id> args) {
        return apply(function, std::span(args.begin(), args.size()));
    }
    Id negate(Id a) { return multiply({number(-1), a}); }
    Id subtract(Id a, Id b) { return add({a, negate(b)}); }
    Id divide(Id a, Id b) { return multiply({a, power(b, number(-1))}); }
    Id sqrt(Id a) { return power(a, number(Number::ratio(1, 2))); }

    /// Both hold only until the next node is built.
    const Node& operator[](Id id) const { return nodes_[id]; }
    std::span<const Id> args(Id id) const { return {args_.data() + nodes_[id].first_arg, nodes_[id].arg_count}; }

    Id size() const { return static_cast<Id>(nodes_.size()); }
    /// The canonical order of factors, and of terms of one degree: below 0 where a comes before b.
    int compare(Id a, Id b) const;
    bool is_number(Id id) const { return nodes_[id].op == Op::Number; }
    bool is_undefined(Id id) const { return is_number(id) && !nodes_[id].number.finite(); }

    friend Id copy(Graph& to, const Graph& from, Id root);

private:
    struct Term {
        Id rest;
        Number coefficient;
    };

    Id leaf(Op op, int index);
    Id intern(Node node, std::span<const Id> args);
    Id build(Op op, std::span<const Id> args);
    Term split_coefficient(Id term);
    Id scaled(Id rest, const Number& coefficient);
    Id distribute(const Number& coefficient, Id sum);
    Id number_power(const Number& base, const Number& exponent);
    Id folded(Op function, std::span<const Id> args);
    void sort_terms(std::vector<Id>& terms) const;
    double constant_value(Op op, std::span<const Id> args) const;
    double degree(Op op, std::span<const Id> args) const;
    std::uint8_t rank(const Node& node, std::span<const Id> args) const;
    void grow_table();

    static constexpr Id kNone = ~Id{0};

    std::vector<Node> nodes_;
    std::vector<Id> args_;
    std::vector<std::uint64_t> hashes_;
    std::vector<Id> table_;  // open addressing; a power of two
};

/// The node's copy in another graph: equal expressions of two graphs get the same id.
Id copy(Graph& to, const Graph& from, Id root);

/// ∂/∂x, ∂/∂y or ∂/∂z, exactly. abs(u) gives sign(u) u′; min and max the derivative of the branch that is selected,
/// of the first where both are equal; sign, floor and what depends on no variable give 0.
Id derivative(Graph& graph, Id root, int variable);

/// Which nodes root is made of, itself included.
std::vector<bool> reachable(const Graph& graph, Id root);

/// The letters of kParameterNames that the expression contains.
std::string parameters_of(const Graph& graph, Id root);

/// The function's name as it is written, "sin"; empty for what is no function.
std::string_view function_name(Op op);

}  // namespace normalscope::formulas

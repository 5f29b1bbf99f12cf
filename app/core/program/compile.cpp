#include "core/program/compile.h"

#include "core/program/steps.h"

#include <algorithm>
#include <numbers>
#include <unordered_map>

namespace normalscope::formulas {

namespace {

struct Hash {
    std::size_t operator()(const Instruction& i) const {
        auto hash = static_cast<std::uint64_t>(i.code);
        for (const std::uint64_t v : {std::uint64_t{i.a}, std::uint64_t{i.b}, std::uint64_t{i.c},
                                      std::uint64_t{std::hash<double>()(i.constant)}})
            hash = (hash ^ v) * 0xBF58476D1CE4E5B9u;
        return static_cast<std::size_t>(hash ^ hash >> 31);
    }
};

using Step = std::uint32_t;

class Compiler {
public:
    Compiler(const Graph& graph, const std::optional<Parameters>& parameters) : g_(graph), parameters_(parameters) {}

    Program run(Id root) {
        const std::vector<bool> reached = reachable(g_, root);
        steps_.resize(root + 1);
        for (Id id = 0; id <= root; ++id)
            if (reached[id]) steps_[id] = step(id);
        return without_unused(steps_[root]);
    }

private:
    Step step(Id id) {
        const Node& node = g_[id];
        const std::span<const Id> args = g_.args(id);
        if (node.constant) return constant(node.value);
        switch (node.op) {
            case Op::Parameter:
                if (parameters_) return constant((*parameters_)[node.index]);
                return emit({.code = Code::Parameter, .constant = static_cast<double>(node.index)});
            case Op::Variable: return emit({.code = Code::Variable, .a = node.index});
            case Op::Sum: return sum(args);
            case Op::Product: return product(args);
            case Op::Power: return power(args[0], args[1]);
            case Op::Min: return emit({.code = Code::Min, .a = steps_[args[0]], .b = steps_[args[1]]});
            case Op::Max: return emit({.code = Code::Max, .a = steps_[args[0]], .b = steps_[args[1]]});
            case Op::Atan2: return emit({.code = Code::Atan2, .a = steps_[args[0]], .b = steps_[args[1]]});
            case Op::Where:
                return emit({.code = Code::Where, .a = steps_[args[0]], .b = steps_[args[1]], .c = steps_[args[2]]});
            default: return emit({.code = function(node.op), .a = steps_[args[0]]});
        }
    }

    static Code function(Op op) {
        constexpr auto offset = static_cast<int>(Code::Log) - static_cast<int>(Op::Log);
        static_assert(static_cast<int>(Op::Floor) + offset == static_cast<int>(Code::Floor));
        return static_cast<Code>(static_cast<int>(op) + offset);
    }

    Step constant(double v) { return emit({.constant = v}); }
    bool is(Step s, double v) const { return program_[s].code == Code::Constant && program_[s].constant == v; }

    Step emit(Instruction i) {
        const int n = operands(i.code);
        const std::array<Step, 3> args{i.a, i.b, i.c};
        const auto first = args.begin(), last = args.begin() + n;
        i.varies = i.code == Code::Variable || std::any_of(first, last, [&](Step s) { return program_[s].varies; });
        if (n > 0 && std::all_of(first, last, [&](Step s) { return program_[s].code == Code::Constant; })) {
            const auto value = [&](int k) {
                return k < n ? program_[args[static_cast<std::size_t>(k)]].constant : 0.0;
            };
            i = {.constant = result(i, value(0), value(1), value(2))};
        }
        const auto [found, inserted] = known_.try_emplace(i, static_cast<Step>(program_.size()));
        if (inserted) program_.push_back(i);
        return found->second;
    }

    Step multiply(Step a, Step b) {
        if (is(a, 0.0) || is(b, 0.0)) return constant(0.0);
        if (is(a, 1.0)) return b;
        if (is(b, 1.0)) return a;
        if (is(a, -1.0)) return emit({.code = Code::Negate, .a = b});
        return emit({.code = Code::Multiply, .a = a, .b = b});
    }

    Step sum(std::span<const Id> args) {
        std::optional<Step> total;
        for (const Id a : args) {
            // x − 2y rather than x + (−2)y
            const bool product = g_[a].op == Op::Product;
            const Id head = product ? g_.args(a)[0] : a;
            const bool minus = total && g_.is_number(head) && g_[head].number.negative();
            const Step s = !minus ? steps_[a] : product ? scaled_product(g_.args(a), -1.0) : constant(-g_[a].value);
            if (!total)
                total = s;
            else if (!is(s, 0.0))
                total = emit({.code = minus ? Code::Subtract : Code::Add, .a = *total, .b = s});
        }
        return *total;
    }

    Step product(std::span<const Id> factors) { return scaled_product(factors, 1.0); }

    Step scaled_product(std::span<const Id> factors, double scale) {
        std::optional<Step> above, below;
        const auto append = [&](std::optional<Step>& product, Step s) {
            product = product ? multiply(*product, s) : s;
        };
        for (const Id f : factors) {
            const Id exponent = g_[f].op == Op::Power ? g_.args(f)[1] : f;
            if (g_.is_number(f))
                scale *= g_[f].value;
            else if (exponent != f && !g_[f].constant && g_.is_number(exponent) && g_[exponent].number.negative())
                append(below, number_power(steps_[g_.args(f)[0]], -g_[exponent].number));
            else
                append(above, steps_[f]);
        }
        Step result = above ? multiply(constant(scale), *above) : constant(scale);
        if (below) result = emit({.code = Code::Divide, .a = result, .b = *below});
        return result;
    }

    Step power(Id base, Id exponent) {
        if (g_.is_number(exponent)) return number_power(steps_[base], g_[exponent].number);
        const Step b = steps_[base], e = steps_[exponent];
        if (g_[base].op == Op::Euler) return emit({.code = Code::Exp, .a = e});
        if (program_[e].code == Code::Constant) {  // of a parameter; 0.5 of a slider is the fraction 1/2
            const Number number = Number::from_double(program_[e].constant);
            return number.finite() ? number_power(b, number) : constant(real::kNaN);
        }
        return emit({.code = Code::Power, .a = b, .b = e});
    }

    Step number_power(Step base, const Number& exponent) {
        if (exponent.zero()) return constant(1.0);
        if (exponent.one()) return base;
        if (exponent == Number(-1)) return emit({.code = Code::Divide, .a = constant(1.0), .b = base});
        if (exponent == Number::ratio(1, 2)) return emit({.code = Code::Sqrt, .a = base});
        return emit({.code = exponent.integer() ? Code::IntegerPower : Code::RealPower,
                     .parity = parity(exponent),
                     .a = base,
                     .constant = exponent.value()});
    }

    // What was folded away leaves steps behind that nothing uses.
    Program without_unused(Step root) const {
        std::vector<bool> used(root + 1, false);
        used[root] = true;
        for (Step s = root + 1; s-- > 0;) {
            if (!used[s]) continue;
            const int n = operands(program_[s].code);
            for (const auto& [i, arg] : {std::pair{1, program_[s].a}, {2, program_[s].b}, {3, program_[s].c}})
                if (i <= n) used[arg] = true;
        }
        std::vector<Step> place(root + 1);
        Program program;
        for (Step s = 0; s <= root; ++s) {
            if (!used[s]) continue;
            place[s] = static_cast<Step>(program.size());
            Instruction i = program_[s];
            const int n = operands(i.code);
            if (n > 0) i.a = place[i.a];
            if (n > 1) i.b = place[i.b];
            if (n > 2) i.c = place[i.c];
            program.push_back(i);
        }
        return program;
    }

    const Graph& g_;
    const std::optional<Parameters>& parameters_;
    Program program_;
    std::vector<Step> steps_;
    std::unordered_map<Instruction, Step, Hash> known_;
};

}  // namespace

Program compile(const Graph& graph, Id root, const std::optional<Parameters>& parameters) {
    return Compiler(graph, parameters).run(root);
}

}  // namespace normalscope::formulas

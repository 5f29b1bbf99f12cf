#include "core/formula/print.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace normalscope::formulas {

namespace {

using Kind = Piece::Kind;

enum class Place { Free, Factor, Base };  // brackets: never, around sums, around all that is not one sign

// Something still to be written: a piece, or an expression.
struct Item {
    std::optional<Piece> piece;
    Id id = 0;
    Place place = Place::Free;
    bool unsigned_term = false;  // without its sign, which has been written
};
using Items = std::vector<Item>;

void put(Items& items, Kind kind, std::string text = {}, bool compound = false) {
    items.push_back({Piece{kind, std::move(text), compound}});
}
void put(Items& items, Id id, Place place, bool unsigned_term = false) {
    items.push_back({std::nullopt, id, place, unsigned_term});
}

class Writer {
public:
    Writer(const Graph& graph, std::size_t most) : g_(graph), most_(most) {}

    // Works on a stack of its own: an expression may be nested more deeply than the machine's stack is deep.
    std::vector<Piece> run(Id root) {
        Items stack, expansion;
        put(stack, root, Place::Free);
        while (!stack.empty()) {
            Item item = std::move(stack.back());
            stack.pop_back();
            if (item.piece) {
                result_.push_back(std::move(*item.piece));
            } else {
                expansion.clear();
                expand(item, expansion);
                std::move(expansion.rbegin(), expansion.rend(), std::back_inserter(stack));
            }
            if (result_.size() > most_) {
                result_.push_back({Kind::Truncated});
                break;
            }
        }
        return std::move(result_);
    }

private:
    bool negative(Id id) const {
        if (g_[id].op == Op::Product) id = g_.args(id)[0];
        return g_.is_number(id) && g_[id].number.negative();
    }
    bool divides(Id factor) const {  // written below the line
        if (g_[factor].op != Op::Power) return false;
        const std::span<const Id> args = g_.args(factor);
        return g_.is_number(args[1]) && g_[args[1]].number.negative() && g_[args[0]].op != Op::Euler;
    }
    // One sign, or what has brackets of its own.
    bool atomic(Id id) const {
        switch (g_[id].op) {
            case Op::Number:
                return !g_[id].number.negative() && g_[id].number.finite() && !is_fraction(g_[id].number) &&
                       decimal(g_[id].number).find('e') == std::string::npos;
            case Op::Sum:
            case Op::Product:
            case Op::Power:
            case Op::Where: return false;
            default: return true;
        }
    }
    bool is_root(Id id) const {
        if (g_[id].op != Op::Power) return false;
        const Id exponent = g_.args(id)[1];
        return g_.is_number(exponent) && g_[exponent].number == Number::ratio(1, 2);
    }
    static bool is_fraction(const Number& n) { return n.exact() && decimal(n).empty(); }

    void expand(const Item& item, Items& out) const {
        const Id id = item.id;
        const Op op = g_[id].op;
        const bool needs = (item.place == Place::Base && !atomic(id)) || (item.place == Place::Factor && op == Op::Sum);
        if (needs) {
            put(out, Kind::Open);
            put(out, id, Place::Free);
            put(out, Kind::Close);
            return;
        }
        switch (op) {
            case Op::Number: return number(g_[id].number, item.unsigned_term, out);
            case Op::Pi: return put(out, Kind::Name, "pi");
            case Op::Euler: return put(out, Kind::Name, "e");
            case Op::Parameter: return put(out, Kind::Name, std::string(kParameterNames.substr(g_[id].index, 1)));
            case Op::Variable: return put(out, Kind::Name, std::string(kVariableNames.substr(g_[id].index, 1)));
            case Op::Sum: return sum(id, out);
            case Op::Product: return product(g_.args(id), item.unsigned_term, out);
            case Op::Power:
                if (divides(id)) return product(std::span(&id, 1), false, out);
                return power(g_.args(id)[0], g_.args(id)[1], out);
            case Op::Abs:
                put(out, Kind::AbsBegin);
                put(out, g_.args(id)[0], Place::Free);
                return put(out, Kind::AbsEnd);
            case Op::Where:
                put(out, Kind::CasesBegin);
                put(out, g_.args(id)[0], Place::Free);
                put(out, Kind::CasesWhere);
                put(out, g_.args(id)[1], Place::Free);
                put(out, Kind::CasesElse);
                put(out, g_.args(id)[2], Place::Free);
                return put(out, Kind::CasesEnd);
            default:
                put(out, Kind::Function, std::string(function_name(op)));
                put(out, Kind::Open);
                for (std::size_t i = 0; i < g_.args(id).size(); ++i) {
                    if (i > 0) put(out, Kind::Comma);
                    put(out, g_.args(id)[i], Place::Free);
                }
                put(out, Kind::Close);
        }
    }

    void number(const Number& n, bool unsigned_term, Items& out) const {
        if (!n.finite()) return put(out, Kind::Name, "undefined");
        const Number size = n.negative() ? -n : n;
        if (n.negative() && !unsigned_term) put(out, Kind::Negative);
        if (!is_fraction(size)) return put(out, Kind::Number, decimal(size));
        put(out, Kind::FractionBegin);
        put(out, Kind::Number, std::to_string(size.numerator()));
        put(out, Kind::FractionOver);
        put(out, Kind::Number, std::to_string(size.denominator()));
        put(out, Kind::FractionEnd);
    }

    // 1 − x² rather than −x² + 1: the first positive term leads, where there is one.
    void sum(Id id, Items& out) const {
        const std::span<const Id> terms = g_.args(id);
        const auto leader = std::ranges::find_if(terms, [&](Id t) { return !negative(t); });
        const Id lead = leader == terms.end() ? terms[0] : *leader;
        if (negative(lead)) put(out, Kind::Negative);
        put(out, lead, Place::Free, negative(lead));
        for (const Id term : terms) {
            if (term == lead) continue;
            put(out, negative(term) ? Kind::Minus : Kind::Plus);
            put(out, term, Place::Free, negative(term));
        }
    }

    void power(Id base, Id exponent, Items& out) const {
        if (g_.is_number(exponent) && g_[exponent].number == Number::ratio(1, 2)) {
            put(out, Kind::RootBegin, {}, !atomic(base));
            put(out, base, Place::Free);
            return put(out, Kind::RootEnd);
        }
        put(out, base, Place::Base);
        put(out, Kind::SuperscriptBegin, {}, !atomic(exponent));
        put(out, exponent, Place::Free);
        put(out, Kind::SuperscriptEnd);
    }

    void product(std::span<const Id> factors, bool unsigned_term, Items& out) const {
        Number coefficient = 1;
        std::vector<Id> above, below;
        for (const Id f : factors) {
            if (g_.is_number(f))
                coefficient = g_[f].number;
            else
                (divides(f) ? below : above).push_back(f);
        }
        if (coefficient.negative()) {
            if (!unsigned_term) put(out, Kind::Negative);
            coefficient = -coefficient;
        }
        std::string over = is_fraction(coefficient) ? std::to_string(coefficient.numerator()) : decimal(coefficient);
        const std::string under = is_fraction(coefficient) ? std::to_string(coefficient.denominator()) : std::string();
        if (over == "1" && !above.empty()) over.clear();

        const bool line = !below.empty() || !under.empty();
        if (!line) return row(over, above, false, false, out);
        const auto lone_sum = [&](const std::string& n, const std::vector<Id>& v) {
            return n.empty() && v.size() == 1 && g_[v[0]].op == Op::Sum;
        };
        put(out, Kind::FractionBegin, {}, lone_sum(over, above));
        row(over, above, false, lone_sum(over, above), out);
        const bool lone = (under.empty() ? 0 : 1) + below.size() == 1;
        const bool sum_below = lone && !below.empty() && bare(below[0]) && g_[g_.args(below[0])[0]].op == Op::Sum;
        put(out, Kind::FractionOver, {}, !lone || sum_below);
        row(under, below, true, sum_below, out);
        put(out, Kind::FractionEnd);
    }

    // A factor 1/u whose denominator is u itself.
    bool bare(Id factor) const { return g_[g_.args(factor)[1]].number == Number(-1); }

    void row(const std::string& number, const std::vector<Id>& factors, bool inverted, bool free, Items& out) const {
        Kind last = Kind::Open;  // nothing yet
        std::string letters;     // the names that stand together, up to here
        if (!number.empty()) {
            put(out, Kind::Number, number);
            last = Kind::Number;
        }
        for (const Id f : factors) {
            const std::size_t begin = out.size();
            const Op op = g_[f].op;
            if (!inverted) {
                put(out, f, free ? Place::Free : Place::Factor);
            } else if (bare(f)) {
                put(out, g_.args(f)[0], free ? Place::Free : Place::Base);
            } else {
                const Number exponent = -g_[g_.args(f)[1]].number;
                inverse_power(g_.args(f)[0], exponent, out);
            }
            const Id base = op == Op::Power ? g_.args(f)[0] : f;
            const bool root = is_root(f) || (inverted && g_[g_.args(f)[1]].number == Number::ratio(-1, 2));
            const bool digits = g_.is_number(base) && !root && atomic(base);
            const bool name =
                (op == Op::Variable || op == Op::Parameter || op == Op::Euler) ||
                (inverted && bare(f) && g_[base].op != Op::Pi && g_.args(base).empty() && !g_.is_number(base));
            std::optional<Kind> between;
            if (last != Kind::Open) {
                const bool bracket = g_[base].op == Op::Sum && !root;
                if (digits)
                    between = Kind::Times;
                else if (bracket ? letters.size() > 1 && letters.find_first_not_of(kVariableNames) != letters.npos
                                 : last != Kind::Number && !(last == Kind::Name && letters_first(base, root)))
                    between = Kind::Space;  // before a bracket: ab(x + 1) would be a function
            }
            if (between) out.insert(out.begin() + static_cast<std::ptrdiff_t>(begin), Item{Piece{*between}});
            last = name ? Kind::Name : Kind::Close;
            if (!name || between) letters.clear();
            if (name) letters += letter(base);
        }
    }

    char letter(Id leaf) const {
        const Node& node = g_[leaf];
        if (node.op == Op::Variable) return kVariableNames[node.index];
        return node.op == Op::Parameter ? kParameterNames[node.index] : 'e';
    }
    // Single letters may follow each other.
    bool letters_first(Id base, bool root) const {
        const Op op = g_[base].op;
        return !root && (op == Op::Variable || op == Op::Parameter);
    }

    void inverse_power(Id base, const Number& exponent, Items& out) const {
        if (exponent == Number::ratio(1, 2)) {
            put(out, Kind::RootBegin, {}, !atomic(base));
            put(out, base, Place::Free);
            return put(out, Kind::RootEnd);
        }
        put(out, base, Place::Base);
        const bool compound = is_fraction(exponent) || decimal(exponent).find('e') != std::string::npos;
        put(out, Kind::SuperscriptBegin, {}, compound);
        number(exponent, true, out);
        put(out, Kind::SuperscriptEnd);
    }

    const Graph& g_;
    std::size_t most_;
    std::vector<Piece> result_;
};

}  // namespace

std::vector<Piece> pieces(const Graph& graph, Id root, std::size_t most) { return Writer(graph, most).run(root); }

}  // namespace normalscope::formulas

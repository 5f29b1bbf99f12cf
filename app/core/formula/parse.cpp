// Dijkstra's shunting yard: operators wait on a stack of our own, so no nesting is too deep for the machine's.

#include "core/formula/parse.h"

#include "core/formula/lexer.h"
#include "core/formula/operand.h"
#include "core/formula/syntax_error.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace normalscope::formulas {

namespace {

// How tightly operators bind. A function without brackets takes what binds more tightly than it does.
enum Binding : int { kSum = 1, kProduct, kBareFunction, kTightProduct, kMinus, kPower };

enum class Kind { Group, Bars, Add, Subtract, Multiply, Divide, Negate, Power, BareFunction };

struct Pending {
    Kind kind;
    int binding = 0;  // of brackets: 0, nothing reaches across
    std::size_t column = 1;
    Token function{};           // of a Group that is a call, and of a BareFunction
    Number function_power = 1;  // 2 of sin^2
    std::size_t first_operand = 0;
};

class Parser {
public:
    Parser(Graph& graph, std::string_view text) : g_(graph), tokens_(tokens(text)) {}

    Id run() {
        skip_left_side();
        for (; token().type != TokenType::End; ++at_) {
            if (wants_operand_)
                operand_token();
            else
                operator_token();
        }
        if (wants_operand_) fail_operand();
        const Id result = finish();
        return left_ ? g_.subtract(*left_, result) : result;
    }

private:
    const Token& token() const { return tokens_[at_]; }
    static std::string quoted(const Token& t) {
        return t.type == TokenType::End ? "the end" : "\"" + t.text.substr(0, 40) + "\"";
    }
    [[noreturn]] void fail_operand() const {
        throw SyntaxError(token().column, "expected a number, a name or \"(\", found " + quoted(token()));
    }

    // "f(x, y, z) = …" names what follows; f alone is a parameter.
    void skip_left_side() {
        constexpr std::string_view kText = "f(x,y,z)=";
        if (tokens_.size() <= kText.size()) return;
        for (std::size_t i = 0; i < kText.size(); ++i)
            if (tokens_[i].text != kText.substr(i, 1)) return;
        at_ = kText.size();
    }

    void operand_token() {
        const Token& t = token();
        switch (t.type) {
            case TokenType::Number: return push_leaf(g_.number(t.number));
            case TokenType::Leaf:
                switch (t.op) {
                    case Op::Pi: return push_leaf(g_.pi());
                    case Op::Euler: return push_leaf(g_.euler());
                    case Op::Variable: return push_leaf(g_.variable(t.index));
                    default: return push_leaf(g_.parameter(t.index));
                }
            case TokenType::Function: return function_token();
            case TokenType::Open: return open({Kind::Group, 0, t.column});
            case TokenType::Bar: return open({Kind::Bars, 0, t.column});
            case TokenType::Minus: pending_.push_back({Kind::Negate, kMinus, t.column}); return;
            case TokenType::Plus: return;
            default: fail_operand();
        }
    }

    void push_leaf(Id id) {
        operands_.push_back({Operand::Open::No, {id}, token().column});
        wants_operand_ = false;
    }

    void open(Pending p) {
        p.first_operand = operands_.size();
        pending_.push_back(std::move(p));
    }

    void function_token() {
        // √2 x is √2·x, as one draws it.
        Pending call{Kind::BareFunction, token().text == "√" ? kMinus : kBareFunction, token().column, token()};
        ++at_;
        const bool caret = token().type == TokenType::Power && tokens_[at_ + 1].type != TokenType::Open;
        if (caret) ++at_;
        if (caret || token().type == TokenType::Superscript) {
            const bool number = token().type == TokenType::Number || token().type == TokenType::Superscript;
            if (!number || !token().number.integer() || token().number.negative())
                throw SyntaxError(token().column, "expected a whole power of " + call.function.text + ", found " +
                                                      quoted(token()) +
                                                      "; an inverse is written asin, acosh and so on");
            call.function_power = token().number;
            ++at_;
        }
        if (token().type == TokenType::Open) {
            call.kind = Kind::Group;
            call.binding = 0;
            return open(std::move(call));
        }
        if (call.function.function->fewest > 1)
            throw SyntaxError(token().column,
                              "expected \"(\" after " + call.function.text + ", found " + quoted(token()));
        pending_.push_back(std::move(call));
        --at_;  // the argument comes next
    }

    void operator_token() {
        const Token& t = token();
        switch (t.type) {
            case TokenType::Plus: return push_operator(Kind::Add, kSum);
            case TokenType::Minus: return push_operator(Kind::Subtract, kSum);
            case TokenType::Times: return push_operator(Kind::Multiply, kProduct);
            case TokenType::Divide: return push_operator(Kind::Divide, kProduct);
            case TokenType::Power:
                pending_.push_back({Kind::Power, kPower, t.column});
                wants_operand_ = true;
                return;
            case TokenType::Superscript: return raise(g_.number(t.number), t.column);
            case TokenType::Close: return close_group();
            case TokenType::Bar:
                if (innermost() && innermost()->kind == Kind::Bars) return close_bars();
                break;
            case TokenType::Comma: return comma();
            case TokenType::Equals: return equals();
            case TokenType::Number:
                if (tokens_[at_ - 1].type == TokenType::Number)
                    throw SyntaxError(t.column, "expected an operator between two numbers, found " + quoted(t));
                break;
            default: break;
        }
        multiply_implicitly();
    }

    void push_operator(Kind kind, int binding) {
        reduce(binding);
        pending_.push_back({kind, binding, token().column});
        wants_operand_ = true;
    }

    void multiply_implicitly() {
        refuse_sin2_of_x();
        reduce(kTightProduct);
        const bool letters = token().type == TokenType::Number || token().type == TokenType::Leaf;
        const bool tight = letters && !pending_.empty() && pending_.back().kind == Kind::BareFunction;
        push_operator(Kind::Multiply, tight ? kTightProduct : kProduct);
        --at_;  // the second factor comes next
    }

    // sin2(x) is no product of sin 2 and x to anyone who writes it.
    void refuse_sin2_of_x() const {
        if (token().type != TokenType::Open || at_ < 2) return;
        const Token &name = tokens_[at_ - 2], &digits = tokens_[at_ - 1];
        if (name.type != TokenType::Function || name.text == "√" || digits.type != TokenType::Number) return;
        const std::string f = name.text, n = digits.text.substr(0, 40);
        throw SyntaxError(name.column, "\"" + f + n + "(\" is not a function; write " + f + "(" + n + "*(…)), " + f +
                                           "(" + n + ")*(…) or " + f + "(…)^" + n +
                                           ". Known are: " + known_functions());
    }

    const Pending* innermost() const {
        const auto found = std::ranges::find(pending_.rbegin(), pending_.rend(), 0, &Pending::binding);
        return found == pending_.rend() ? nullptr : &*found;
    }

    void close_group() {
        reduce(kSum);
        if (pending_.empty())
            throw SyntaxError(token().column, "expected an operator or the end: no \"(\" belongs to this \")\"");
        if (pending_.back().kind == Kind::Bars) throw SyntaxError(token().column, "expected \"|\" before \")\"");
        const Pending group = std::move(pending_.back());
        pending_.pop_back();
        if (group.function.type != TokenType::Function) return;
        std::vector<Id> args;
        for (std::size_t i = group.first_operand; i < operands_.size(); ++i) args.push_back(closed(operands_[i]));
        const auto fewest = group.function.function->fewest, most = group.function.function->most;
        if (args.size() < fewest)
            throw SyntaxError(token().column, "expected \",\": " + group.function.text + " has " +
                                                  std::to_string(fewest) + " arguments" +
                                                  (most > fewest ? " or more" : ""));
        operands_.resize(group.first_operand);
        operands_.push_back({Operand::Open::No, {called(group, args)}, group.column});
    }

    void close_bars() {
        reduce(kSum);
        pending_.pop_back();
        Operand& inside = operands_.back();
        inside = {Operand::Open::No, {g_.apply(Op::Abs, {closed(inside)})}, inside.column};
    }

    void comma() {
        reduce(kSum);
        const bool call = !pending_.empty() && pending_.back().function.type == TokenType::Function;
        if (!call)
            throw SyntaxError(token().column, std::string("expected an operator") +
                                                  (pending_.empty() ? "" : " or a closing bracket") + ", found \",\"");
        const Pending& group = pending_.back();
        const std::size_t most = group.function.function->most;
        if (operands_.size() - group.first_operand >= most)
            throw SyntaxError(token().column, "expected \")\": " + group.function.text + " has " +
                                                  std::to_string(most) + (most == 1 ? " argument" : " arguments"));
        wants_operand_ = true;
    }

    void equals() {
        if (left_) throw SyntaxError(token().column, "expected one \"=\" only");
        left_ = finish();
        wants_operand_ = true;
    }

    // One side, complete.
    Id finish() {
        reduce(kSum);
        if (!pending_.empty())
            throw SyntaxError(token().column,
                              std::string("expected \"") + (pending_.back().kind == Kind::Bars ? "|" : ")") +
                                  "\" for the one opened at column " + std::to_string(pending_.back().column) +
                                  ", found " + quoted(token()));
        const Id result = closed(operands_.back());
        operands_.clear();
        return result;
    }

    void reduce(int binding) {
        while (!pending_.empty() && pending_.back().binding >= binding) {
            const Pending p = std::move(pending_.back());
            pending_.pop_back();
            perform(p);
        }
    }

    void perform(const Pending& p) {
        Operand right = std::move(operands_.back());
        if (p.kind == Kind::Negate) {
            operands_.back() = joined(Operand::Open::Product, std::move(right), {Operand::Open::No, {g_.number(-1)}});
            return;
        }
        if (p.kind == Kind::BareFunction) {
            operands_.back() = {Operand::Open::No, {called(p, {closed(right)})}, p.column};
            return;
        }
        operands_.pop_back();
        Operand left = std::move(operands_.back());
        switch (p.kind) {
            case Kind::Add: operands_.back() = joined(Operand::Open::Sum, std::move(left), std::move(right)); break;
            case Kind::Subtract:
                right = {Operand::Open::No, {g_.negate(closed(right))}};
                operands_.back() = joined(Operand::Open::Sum, std::move(left), std::move(right));
                break;
            case Kind::Divide:
                // 1/(2(x+1)): factor by factor, so that the 2 is not multiplied out.
                if (right.open != Operand::Open::Product) right.parts = {closed(right)};
                for (Id& f : right.parts) {
                    f = g_.power(f, g_.number(-1));
                    if (g_.is_undefined(f)) throw SyntaxError(p.column, "this divides by zero");
                }
                right.open = Operand::Open::Product;
                [[fallthrough]];
            case Kind::Multiply:
                operands_.back() = joined(Operand::Open::Product, std::move(left), std::move(right));
                break;
            default: operands_.back() = std::move(left); raise(closed(right), p.column);
        }
    }

    void raise(Id exponent, std::size_t column) {
        Operand& operand = operands_.back();
        const Id base = closed(operand);
        if (g_[base].constant && g_[base].value < 0.0 && !g_[exponent].constant)
            throw SyntaxError(column, "a negative number has no real value at an exponent that varies");
        const Id result = g_.power(base, exponent);
        if (g_.is_undefined(result))
            throw SyntaxError(column, "this power has no real value, or one that is too large");
        operand = {Operand::Open::No, {result}, operand.column};
    }

    Id called(const Pending& call, const std::vector<Id>& args) {
        Id result = call.function.function->apply(g_, args);
        result = g_.power(result, g_.number(call.function_power));
        if (g_.is_undefined(result))
            throw SyntaxError(call.column, call.function.text + " has no real value here, or one that is too large");
        return result;
    }

    Operand joined(Operand::Open open, Operand a, Operand b) {
        return formulas::joined(g_, open, std::move(a), std::move(b));
    }
    Id closed(const Operand& o) { return formulas::closed(g_, o); }

    Graph& g_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    bool wants_operand_ = true;
    std::vector<Pending> pending_;
    std::vector<Operand> operands_;
    std::optional<Id> left_;
};

}  // namespace

Id parse(Graph& graph, std::string_view text) { return Parser(graph, text).run(); }

}  // namespace normalscope::formulas

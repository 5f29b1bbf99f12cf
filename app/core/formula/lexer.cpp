#include "core/formula/lexer.h"

#include "core/base/nearest.h"
#include "core/base/text.h"
#include "core/formula/syntax_error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace normalscope::formulas {

namespace {

struct Name {
    std::string_view text;
    Token token;
};

Token leaf(Op op, std::size_t index = 0) {
    return {.type = TokenType::Leaf, .op = op, .index = static_cast<int>(index)};
}
Token call(const Function& f) { return {.type = TokenType::Function, .function = &f}; }

std::vector<Name> make_names() {
    std::vector<Name> names;
    for (const Function& f : functions()) names.push_back({f.name, call(f)});
    names.push_back({"pi", leaf(Op::Pi)});
    names.push_back({"e", leaf(Op::Euler)});
    for (std::size_t i = 0; i < kVariableNames.size(); ++i)
        names.push_back({kVariableNames.substr(i, 1), leaf(Op::Variable, i)});
    for (std::size_t i = 0; i < kParameterNames.size(); ++i)
        names.push_back({kParameterNames.substr(i, 1), leaf(Op::Parameter, i)});
    return names;
}

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_open(char c) { return c == '(' || c == '[' || c == '{'; }
bool is_digit(char c) { return '0' <= c && c <= '9'; }

// The length of the character that begins with this byte of UTF-8; 0 if none does.
std::size_t length_of(std::string_view rest) {
    const auto lead = static_cast<unsigned char>(rest[0]);
    const std::size_t n = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
    if (n == 0 || n > rest.size()) return 0;
    for (std::size_t i = 1; i < n; ++i)
        if ((static_cast<unsigned char>(rest[i]) & 0xC0) != 0x80) return 0;
    return n;
}

struct Symbol {
    std::string_view text;
    TokenType type;
};
constexpr std::array kSymbols{
    Symbol{"**", TokenType::Power}, Symbol{"+", TokenType::Plus},    Symbol{"-", TokenType::Minus},
    Symbol{"−", TokenType::Minus},  Symbol{"*", TokenType::Times},   Symbol{"·", TokenType::Times},
    Symbol{"×", TokenType::Times},  Symbol{"⋅", TokenType::Times},   Symbol{"/", TokenType::Divide},
    Symbol{"÷", TokenType::Divide}, Symbol{"^", TokenType::Power},   Symbol{"(", TokenType::Open},
    Symbol{"[", TokenType::Open},   Symbol{"{", TokenType::Open},    Symbol{"]", TokenType::Close},
    Symbol{"}", TokenType::Close},  Symbol{")", TokenType::Close},   Symbol{"|", TokenType::Bar},
    Symbol{",", TokenType::Comma},  Symbol{"==", TokenType::Equals}, Symbol{"=", TokenType::Equals}};
struct Fraction {
    std::string_view text;
    std::int64_t numerator, denominator;

    Number value() const { return Number::ratio(numerator, denominator); }
};
constexpr std::array kFractions{Fraction{"½", 1, 2}, Fraction{"⅓", 1, 3}, Fraction{"⅔", 2, 3}, Fraction{"¼", 1, 4},
                                Fraction{"¾", 3, 4}, Fraction{"⅕", 1, 5}, Fraction{"⅖", 2, 5}, Fraction{"⅗", 3, 5},
                                Fraction{"⅘", 4, 5}, Fraction{"⅙", 1, 6}, Fraction{"⅚", 5, 6}, Fraction{"⅛", 1, 8},
                                Fraction{"⅜", 3, 8}, Fraction{"⅝", 5, 8}, Fraction{"⅞", 7, 8}};
const Fraction* fraction_at(std::string_view rest) {
    const auto found = std::ranges::find_if(kFractions, [&](const Fraction& f) { return rest.starts_with(f.text); });
    return found == kFractions.end() ? nullptr : &*found;
}
constexpr std::array<std::string_view, 10> kSuperscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

class Lexer {
public:
    explicit Lexer(std::string_view text) : rest_(text), names_(make_names()) {}

    std::vector<Token> run() {
        for (;;) {
            while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t' || rest_[0] == '\n' || rest_[0] == '\r'))
                skip(1);
            if (column_ > kMostCharacters + 1) too_long();
            if (rest_.find_first_not_of("; \t\n\r") == std::string_view::npos) break;  // x^2 = y;
            next();
        }
        push({}, 0);
        return std::move(tokens_);
    }

private:
    [[noreturn]] void too_long() const {
        throw SyntaxError(kMostCharacters + 1,
                          "the formula has more than " + std::to_string(kMostCharacters) + " characters; shorten it");
    }
    void skip(std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i)
            column_ += (static_cast<unsigned char>(rest_[i]) & 0xC0) != 0x80 ? 1 : 0;
        rest_.remove_prefix(bytes);
    }
    void push(Token token, std::size_t bytes) {
        token.column = column_;
        token.text = rest_.substr(0, bytes);
        tokens_.push_back(std::move(token));
        skip(bytes);
    }

    void next() {
        if (is_digit(rest_[0]) || (rest_[0] == '.' && rest_.size() > 1 && is_digit(rest_[1]))) return number();
        if (is_letter(rest_[0])) return letters();
        for (const Symbol& s : kSymbols)
            if (rest_.starts_with(s.text)) return push({.type = s.type}, s.text.size());
        if (rest_.starts_with("π")) return push(leaf(Op::Pi), std::string_view("π").size());
        if (rest_.starts_with("√")) return push(call(functions().front()), std::string_view("√").size());
        if (superscript()) return;
        if (const Fraction* f = fraction_at(rest_))
            return push({.type = TokenType::Number, .number = f->value()}, f->text.size());
        const std::size_t length = length_of(rest_);
        if (length == 0) throw SyntaxError(column_, "this is not UTF-8 text; type the formula anew");
        if (length == 1 && static_cast<unsigned char>(rest_[0]) < 0x20)
            throw SyntaxError(column_, "expected a formula, found a control character");
        throw SyntaxError(column_, "expected a number, a name, an operator or a bracket, found \"" +
                                       std::string(rest_.substr(0, length)) + "\"");
    }

    void number() {
        std::size_t n = 0;
        bool point = false;
        while (n < rest_.size() && (is_digit(rest_[n]) || (rest_[n] == '.' && !point))) point |= rest_[n++] == '.';
        if (n < rest_.size() && rest_[n] == '.') {
            skip(n);
            throw SyntaxError(column_, "expected an operator, found a second decimal point");
        }
        std::size_t e = n;  // an exponent only if digits follow at once: otherwise it is Euler's number
        if (e < rest_.size() && (rest_[e] == 'e' || rest_[e] == 'E')) {
            ++e;
            if (e < rest_.size() && (rest_[e] == '+' || rest_[e] == '-')) ++e;
            if (e < rest_.size() && is_digit(rest_[e]))
                for (n = e; n < rest_.size() && is_digit(rest_[n]);) ++n;
        }
        Number value = Number::from_decimal(rest_.substr(0, n));
        if (!value.finite()) throw SyntaxError(column_, "this number is too large; the largest is about 1.8e308");
        if (const Fraction* f = point ? nullptr : fraction_at(rest_.substr(n))) {  // 2½ is 5/2
            value = value + f->value();
            n += f->text.size();
        }
        push({.type = TokenType::Number, .number = value}, n);
    }

    bool superscript() {
        std::string digits;
        std::size_t n = 0;
        const bool minus = rest_.starts_with("⁻");
        if (minus) n += std::string_view("⁻").size();
        for (bool found = true; found;) {
            found = false;
            for (std::size_t d = 0; d < kSuperscripts.size(); ++d) {
                if (!rest_.substr(n).starts_with(kSuperscripts[d])) continue;
                digits += static_cast<char>('0' + d);
                n += kSuperscripts[d].size();
                found = true;
                break;
            }
        }
        if (digits.empty()) return false;
        const Number value = Number::from_decimal(digits);
        if (!value.finite()) throw SyntaxError(column_, "this number is too large; the largest is about 1.8e308");
        push({.type = TokenType::Superscript, .number = minus ? -value : value}, n);
        return true;
    }

    // Letters in a row, split into the longest names. log10 and its like end in digits, and take all that follow.
    void letters() {
        std::size_t n = 0;
        while (n < rest_.size() && is_letter(rest_[n])) ++n;
        std::size_t end = n;
        while (end < rest_.size() && (is_digit(rest_[end]) || rest_[end] == '.')) ++end;
        const std::string_view word = rest_.substr(0, n), text = rest_.substr(0, end);
        std::vector<const Name*> parts;
        std::size_t at = 0;
        while (at < n) {
            const Name* longest = nullptr;
            for (const Name& name : names_) {
                const bool fits = !is_digit(name.text.back()) || at + name.text.size() == end;
                if (fits && text.substr(at).starts_with(name.text) &&
                    (!longest || name.text.size() > longest->text.size()))
                    longest = &name;
            }
            if (!longest) unknown(word);
            parts.push_back(longest);
            at += longest->text.size();
        }
        if (at < rest_.size() && is_open(rest_[at])) check_call(word, parts);
        for (const Name* part : parts) push(part->token, part->text.size());
    }

    // xy(z + 1) is a product, and x sin(y) as well; ab(x) may be meant as a function of that name.
    void check_call(std::string_view word, const std::vector<const Name*>& parts) const {
        for (std::size_t i = 0; i < parts.size() && parts.size() > 1; ++i) {
            const Token& t = parts[i]->token;
            const bool last_call = i + 1 == parts.size() && t.type == TokenType::Function;
            if (!last_call && !(t.type == TokenType::Leaf && t.op == Op::Variable)) unknown_function(word);
        }
    }

    [[noreturn]] void unknown_function(std::string_view word) const {
        throw SyntaxError(column_, "unknown function \"" + std::string(word.substr(0, 40)) +
                                       "\"; for a product write * before the bracket. Known are: " + known_functions());
    }

    [[noreturn]] void unknown(std::string_view word) const {
        std::vector<std::string> valid;
        for (const Name& name : names_) valid.emplace_back(name.text);
        const auto meant = nearest(in_small_letters(std::string(word)), valid);
        throw SyntaxError(column_, "unknown name \"" + std::string(word.substr(0, 40)) + (word.size() > 40 ? "…" : "") +
                                       (meant ? "\", did you mean " + *meant + "? Known" : "\"; known") +
                                       " are: " + joined(valid, " "));
    }

    std::string_view rest_;
    std::size_t column_ = 1;
    std::vector<Name> names_;
    std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens(std::string_view text) { return Lexer(text).run(); }

}  // namespace normalscope::formulas

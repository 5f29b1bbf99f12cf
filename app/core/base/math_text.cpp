#include "core/base/math_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace normalscope {

namespace {

using Kind = MathPart::Kind;

struct Raised {
    std::string_view letter, plain;
};
constexpr std::array<Raised, 15> kAbove{{{"⁰", "0"},
                                         {"¹", "1"},
                                         {"²", "2"},
                                         {"³", "3"},
                                         {"⁴", "4"},
                                         {"⁵", "5"},
                                         {"⁶", "6"},
                                         {"⁷", "7"},
                                         {"⁸", "8"},
                                         {"⁹", "9"},
                                         {"⁻", "−"},
                                         {"⁺", "+"},
                                         {"ᵀ", "T"},
                                         {"ᵖ", "p"},
                                         {"ⁿ", "n"}}};
constexpr std::array<Raised, 10> kBelow{{{"₀", "0"},
                                         {"₁", "1"},
                                         {"₂", "2"},
                                         {"₃", "3"},
                                         {"₄", "4"},
                                         {"₅", "5"},
                                         {"₆", "6"},
                                         {"₇", "7"},
                                         {"₈", "8"},
                                         {"₉", "9"}}};

template <std::size_t N>
const Raised* raised_at(const std::array<Raised, N>& list, std::string_view text) {
    const auto it = std::ranges::find_if(list, [&](const Raised& r) { return text.starts_with(r.letter); });
    return it == list.end() ? nullptr : &*it;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_tail(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

bool has(std::string_view text, char c) { return text.find(c) != std::string_view::npos; }

// Without the spaces about each.
std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(at, from), text.size());
        std::string_view part = text.substr(from, end - from);
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        parts.push_back(part);
        from = end + 1;
    }
    return parts;
}

// Where the last name, number or sign of these words begins.
std::size_t last_atom(std::string_view words) {
    std::size_t at = words.size();
    const auto back_over = [&](auto is) {
        while (at > 0 && is(words[at - 1])) --at;
    };
    if (at == 0) return 0;
    if (is_letter(words.back()))
        back_over(is_letter);
    else if (is_digit(words.back()))
        back_over(is_digit);
    else {
        back_over(is_tail);
        if (at > 0) --at;
    }
    return at;
}

class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    MathLine read() {
        while (!rest_.empty())
            if (!structure() && !script()) letter();
        return std::move(line_);
    }

private:
    void add_words(std::string_view words) {
        if (line_.empty() || line_.back().kind != Kind::Words) line_.push_back({});
        line_.back().words += words;
    }
    void letter() {
        if (rest_.size() > 1 && rest_[0] == '\\' && has("_^{}[]*\\", rest_[1])) rest_.remove_prefix(1);
        std::size_t length = 1;
        while (length < rest_.size() && is_tail(rest_[length])) ++length;
        add_words(rest_.substr(0, length));
        rest_.remove_prefix(length);
    }

    // From an opening sign to the one that closes it; the inside, which is taken away with both.
    std::optional<std::string_view> group(char open, char close) {
        if (!rest_.starts_with(open)) return std::nullopt;
        int depth = 0;
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            depth += rest_[i] == open ? 1 : rest_[i] == close ? -1 : 0;
            if (depth > 0) continue;
            const std::string_view inside = rest_.substr(1, i - 1);
            rest_.remove_prefix(i + 1);
            return inside;
        }
        return std::nullopt;
    }
    void put(Kind kind, std::vector<MathLine> lines, std::size_t columns = 0) {
        line_.push_back({kind, {}, std::move(lines), columns});
    }

    bool structure() {
        const std::string_view before = rest_;
        if (rest_.starts_with("**")) {
            const auto end = rest_.find("**", 2);
            if (end == std::string_view::npos || end == 2) return false;
            put(Kind::Bold, {read_math(rest_.substr(2, end - 2))});
            rest_.remove_prefix(end + 2);
            return true;
        }
        if (rest_.starts_with("√{")) {
            rest_.remove_prefix(std::string_view("√").size());
            if (const auto inside = group('{', '}')) return put(Kind::Root, {read_math(*inside)}), true;
        }
        if (const auto over = group('{', '}'); over && rest_.starts_with("/{")) {
            rest_.remove_prefix(1);
            if (const auto under = group('{', '}'))
                return put(Kind::Fraction, {read_math(*over), read_math(*under)}), true;
        }
        rest_ = before;
        if (const auto inside = group('[', ']'); inside && matrix(*inside)) return true;
        rest_ = before;
        return false;
    }

    // Rows between semicolons, entries between commas; all rows as long as each other.
    bool matrix(std::string_view inside) {
        if (!has(inside, ';')) return false;
        std::vector<MathLine> entries;
        std::size_t columns = 0;
        for (const std::string_view row : split(inside, ';')) {
            const std::vector<std::string_view> cells = split(row, ',');
            if (std::exchange(columns, cells.size()) != cells.size() && !entries.empty()) return false;
            for (const std::string_view cell : cells) entries.push_back(read_math(cell));
        }
        put(Kind::Matrix, std::move(entries), columns);
        return true;
    }

    bool script() {
        const bool names = !line_.empty() && (line_.back().kind != Kind::Words || !line_.back().words.ends_with(' '));
        for (const bool above : {false, true}) {
            std::string text;
            while (const Raised* r = above ? raised_at(kAbove, rest_) : raised_at(kBelow, rest_)) {
                text += r->plain;
                rest_.remove_prefix(r->letter.size());
            }
            if (!text.empty()) return attach(read_math(text), above), true;
        }
        if (!names || rest_.size() < 2 || (rest_[0] != '_' && rest_[0] != '^')) return false;
        const std::string_view before = rest_;
        const bool above = rest_[0] == '^';
        rest_.remove_prefix(1);
        if (const auto inside = group('{', '}')) return attach(with_minus(*inside), above), true;
        const std::size_t sign = above && rest_.starts_with('-') ? 1 : 0;
        std::size_t end = sign;
        while (end < rest_.size() && (is_digit(rest_[end]) || (is_letter(rest_[end]) && (!above || end == sign)))) {
            ++end;
            if (above && is_letter(rest_[end - 1])) break;  // M^TM is Mᵀ M
        }
        if (end == sign) return rest_ = before, false;
        const std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return attach(with_minus(text), above), true;
    }
    static MathLine with_minus(std::string_view text) {
        std::string with;
        for (const char c : text) with += c == '-' ? std::string("−") : std::string(1, c);
        return read_math(with);
    }

    void attach(MathLine what, bool above) {
        if (line_.empty() || line_.back().kind != Kind::Scripted || !line_.back().lines[above ? 2 : 1].empty()) {
            MathLine base = take_base();
            put(Kind::Scripted, {std::move(base), {}, {}});
        }
        line_.back().lines[above ? 2 : 1] = std::move(what);
    }

    // What the script belongs to, taken off the line's end.
    MathLine take_base() {
        if (line_.empty()) return {};
        if (line_.back().kind != Kind::Words) {
            MathLine base{std::move(line_.back())};
            line_.pop_back();
            return base;
        }
        if (line_.back().words.ends_with(')'))
            if (auto inside = take_parentheses()) return {MathPart{Kind::Parentheses, {}, {std::move(*inside)}}};
        std::string& words = line_.back().words;
        const std::size_t at = last_atom(words);
        MathLine base{MathPart{Kind::Words, words.substr(at)}};
        words.resize(at);
        if (words.empty()) line_.pop_back();
        return base;
    }
    std::optional<MathLine> take_parentheses() {
        int depth = 0;
        for (std::size_t i = line_.size(); i-- > 0;) {
            if (line_[i].kind != Kind::Words) continue;
            for (std::size_t k = line_[i].words.size(); k-- > 0;) {
                depth += line_[i].words[k] == ')' ? 1 : line_[i].words[k] == '(' ? -1 : 0;
                if (depth > 0 || line_[i].words[k] != '(') continue;
                line_.back().words.pop_back();
                MathLine inside{MathPart{Kind::Words, line_[i].words.substr(k + 1)}};
                for (std::size_t j = i + 1; j < line_.size(); ++j) inside.push_back(std::move(line_[j]));
                line_[i].words.resize(k);
                line_.resize(line_[i].words.empty() ? i : i + 1);
                std::erase_if(inside, [](const MathPart& p) { return p.kind == Kind::Words && p.words.empty(); });
                return inside;
            }
        }
        return std::nullopt;
    }

    std::string_view rest_;
    MathLine line_;
};

std::string plain(const MathLine& line);

template <std::size_t N>
std::string raised(const std::array<Raised, N>& letters, const std::string& plain_text, char sign) {
    std::string result;
    std::string_view rest = plain_text;
    while (!rest.empty()) {
        const auto it = std::ranges::find_if(letters, [&](const Raised& r) { return rest.starts_with(r.plain); });
        if (it == letters.end())
            return sign + (has(plain_text, ' ') ? "{" + plain_text + "}" : plain_text);  // as one would type it
        result += it->letter;
        rest.remove_prefix(it->plain.size());
    }
    return result;
}

std::string in_parentheses(const std::string& text) { return has(text, ' ') ? "(" + text + ")" : text; }

std::string plain(const MathPart& part) {
    const auto line = [&](std::size_t i) { return plain(part.lines[i]); };
    switch (part.kind) {
        case Kind::Words: return part.words;
        case Kind::Scripted: return line(0) + raised(kBelow, line(1), '_') + raised(kAbove, line(2), '^');
        case Kind::Parentheses: return "(" + line(0) + ")";
        case Kind::Fraction: return in_parentheses(line(0)) + "/" + in_parentheses(line(1));
        case Kind::Root: return "√" + in_parentheses(line(0));
        case Kind::Bold: return line(0);
        case Kind::Matrix: break;
    }
    std::string text = "[";
    for (std::size_t i = 0; i < part.lines.size(); ++i)
        text += (i == 0 ? "" : i % part.columns == 0 ? "; " : ", ") + line(i);
    return text + "]";
}

std::string plain(const MathLine& line) {
    std::string text;
    for (const MathPart& part : line) text += plain(part);
    return text;
}

}  // namespace

MathLine read_math(std::string_view utf8) { return Reader(utf8).read(); }

std::string only_words(const MathLine& line) {
    return line.size() == 1 && line[0].kind == Kind::Words ? line[0].words : std::string();
}

std::string symbol_name(const MathPart& part) {
    if (part.kind != Kind::Scripted) return {};
    const std::string base = only_words(part.lines[0]), below = only_words(part.lines[1]);
    const bool known = (base == "n" && (below == "obj" || below == "world" || below == "naive")) ||
                       (base == "v" && (below == "obj" || below == "world"));
    return known ? base + "_" + below : std::string();
}

std::string plain_math(std::string_view utf8) { return plain(read_math(utf8)); }

}  // namespace normalscope

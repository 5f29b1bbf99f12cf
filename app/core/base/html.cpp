#include "core/base/html.h"

#include "core/base/math_text.h"

#include <cctype>
#include <utility>

namespace normalscope {

namespace {

using Kind = MathPart::Kind;

std::string css_class(const std::string& symbol) {
    if (symbol == "n_world") return " class=\"right\"";
    if (symbol == "n_naive") return " class=\"naive\"";
    return symbol.starts_with("v_") ? " class=\"tangent\"" : "";
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string element(std::string_view name, const std::string& inside) {
    return "<" + std::string(name) + ">" + inside + "</" + std::string(name) + ">";
}

// MathML's tokens: names, numbers, and whatever else there is.
std::string tokens(std::string_view words) {
    std::string html;
    while (!words.empty()) {
        std::size_t end = 1;
        const auto run = [&](auto is) {
            while (end < words.size() && is(words[end])) ++end;
        };
        const char* name = "mo";
        if (is_letter(words[0]))
            name = "mi", run(is_letter);
        else if (is_digit(words[0]))
            name = "mn", run([](char c) { return is_digit(c) || c == '.'; });
        else
            run([](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; });
        if (words[0] != ' ') html += element(name, html_text(words.substr(0, end)));
        words.remove_prefix(end);
    }
    return html;
}

std::string mathml(const MathLine& line);

std::string mathml(const MathPart& part) {
    const auto row = [&](std::size_t i) { return element("mrow", mathml(part.lines[i])); };
    switch (part.kind) {
        case Kind::Words: return tokens(part.words);
        case Kind::Scripted:
            if (part.lines[1].empty()) return element("msup", row(0) + row(2));
            if (part.lines[2].empty()) return element("msub", row(0) + row(1));
            return element("msubsup", row(0) + row(1) + row(2));
        case Kind::Parentheses: return element("mrow", "<mo>(</mo>" + mathml(part.lines[0]) + "<mo>)</mo>");
        case Kind::Fraction: return element("mfrac", row(0) + row(1));
        case Kind::Root: return element("msqrt", mathml(part.lines[0]));
        case Kind::Bold: return "<mrow style=\"font-weight: bold\">" + mathml(part.lines[0]) + "</mrow>";
        case Kind::Matrix: break;
    }
    std::string rows, cells;
    for (std::size_t i = 0; i < part.lines.size(); ++i) {
        cells += element("mtd", mathml(part.lines[i]));
        if ((i + 1) % part.columns == 0) rows += element("mtr", std::exchange(cells, {}));
    }
    return element("mrow", "<mo>[</mo>" + element("mtable", rows) + "<mo>]</mo>");
}

std::string mathml(const MathLine& line) {
    std::string html;
    for (const MathPart& part : line) html += mathml(part);
    return html;
}

std::string html_of(const MathLine& line);

// Plain tags as far as they go: every mail program and form has these.
std::string html_of(const MathPart& part) {
    switch (part.kind) {
        case Kind::Words: return html_text(part.words);
        case Kind::Bold: return element("b", html_of(part.lines[0]));
        case Kind::Parentheses: return "(" + html_of(part.lines[0]) + ")";
        case Kind::Scripted: {
            const std::string base = html_of(part.lines[0]), symbol = symbol_name(part);
            std::string html = base.size() == 1 && is_letter(base[0]) ? element("i", base) : base;
            if (!part.lines[1].empty()) html += element("sub", html_of(part.lines[1]));
            if (!symbol.empty()) html = "<span" + css_class(symbol) + ">" + html + "</span>";
            return part.lines[2].empty() ? html : html + element("sup", html_of(part.lines[2]));
        }
        default: return element("math", mathml(part));
    }
}

std::string html_of(const MathLine& line) {
    std::string html;
    for (const MathPart& part : line) html += html_of(part);
    return html;
}

}  // namespace

std::string html_text(std::string_view utf8) {
    std::string html;
    for (const char c : utf8) switch (c) {
            case '&': html += "&amp;"; break;
            case '<': html += "&lt;"; break;
            case '>': html += "&gt;"; break;
            case '"': html += "&quot;"; break;
            default: html += c;
        }
    return html;
}

std::string xml_text(std::string_view utf8) {
    std::string text;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const std::string_view rest = utf8.substr(i, 3);
        const bool is_none = rest == "\uFFFE" || rest == "\uFFFF";
        const auto c = static_cast<unsigned char>(utf8[i]);
        const bool is_control = c < ' ' && c != '\n' && c != '\t';
        text += is_none || is_control ? "\uFFFD" : std::string(1, utf8[i]);
        i += is_none ? 2 : 0;
    }
    return html_text(text);
}

std::string html_math(std::string_view utf8) { return html_of(read_math(utf8)); }

}  // namespace normalscope

#include "core/formula/print.h"

#include <array>
#include <span>
#include <utility>

namespace normalscope::formulas {

namespace {

using Kind = Piece::Kind;

// Writes the pieces in a row; a style says how each looks. What has been opened is closed at the end, truncated or not.
class Line {
public:
    void write(std::string_view text) { line_ += text; }
    void open(std::string_view text, std::string_view closing) {
        line_ += text;
        closing_.push_back(std::string(closing));
    }
    void close() {
        if (closing_.empty()) return;
        line_ += closing_.back();
        closing_.pop_back();
    }
    std::string finish() {
        while (!closing_.empty()) close();
        return std::move(line_);
    }

private:
    std::string line_;
    std::vector<std::string> closing_;
};

void open_if(Line& line, bool compound, std::string_view before = {}) {
    line.write(before);
    line.open(compound ? "(" : "", compound ? ")" : "");
}

// What the two styles of one line have in common.
bool write_plain(Line& line, const Piece& p) {
    switch (p.kind) {
        case Kind::Number:
        case Kind::Function: line.write(p.text); break;
        case Kind::Plus: line.write(" + "); break;
        case Kind::Space: line.write(" "); break;
        case Kind::Comma:
        case Kind::CasesWhere:
        case Kind::CasesElse: line.write(", "); break;
        case Kind::Open: line.open("(", ")"); break;
        case Kind::FractionBegin: open_if(line, p.compound); break;
        case Kind::FractionOver:
            line.close();
            open_if(line, p.compound, "/");
            break;
        case Kind::CasesBegin: line.open("where(", ")"); break;
        case Kind::Close:
        case Kind::AbsEnd:
        case Kind::FractionEnd:
        case Kind::SuperscriptEnd:
        case Kind::RootEnd:
        case Kind::CasesEnd: line.close(); break;
        case Kind::Truncated: line.write("…"); break;
        default: return false;
    }
    return true;
}

// An exponent of digits only, in small raised digits; empty if it is more than that.
std::string raised(std::span<const Piece> rest) {
    constexpr std::array<std::string_view, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const Piece& p : rest) {
        if (p.kind == Kind::SuperscriptEnd) return text;
        if (p.kind == Kind::Negative)
            text += "⁻";
        else if (p.kind != Kind::Number || p.text.find_first_not_of("0123456789") != std::string::npos)
            return {};
        else
            for (const char c : p.text) text += kDigits[static_cast<std::size_t>(c - '0')];
    }
    return {};
}

std::string latex_name(const std::string& text) {
    if (text == "pi") return "\\pi ";
    return text == "undefined" ? "\\text{undefined}" : text;
}

std::string latex_function(const std::string& text) {
    if (text == "asin" || text == "acos" || text == "atan") return "\\arc" + text.substr(1);
    if (text == "asinh" || text == "acosh" || text == "atanh") return "\\operatorname{ar" + text.substr(1) + "}";
    if (text == "floor" || text == "atan2") return "\\operatorname{" + text + "}";
    return text == "sign" ? "\\operatorname{sgn}" : "\\" + text;
}

std::string latex_number(const std::string& text) {
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    std::string exponent = text.substr(e + 1);
    if (exponent[0] == '+') exponent.erase(0, 1);
    return text.substr(0, e) + "\\cdot 10^{" + exponent + "}";
}

}  // namespace

std::string to_text(const std::vector<Piece>& pieces) {
    Line line;
    for (const Piece& p : pieces) {
        if (write_plain(line, p)) continue;
        switch (p.kind) {
            case Kind::Name: line.write(p.text); break;
            case Kind::Minus: line.write(" - "); break;
            case Kind::Negative: line.write("-"); break;
            case Kind::Times: line.write("*"); break;
            case Kind::AbsBegin: line.open("abs(", ")"); break;
            case Kind::SuperscriptBegin: open_if(line, p.compound, "^"); break;
            default: line.open("sqrt(", ")"); break;
        }
    }
    return line.finish();
}

std::string to_unicode(const std::vector<Piece>& pieces) {
    Line line;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& p = pieces[i];
        if (write_plain(line, p)) continue;
        switch (p.kind) {
            case Kind::Name: line.write(p.text == "pi" ? "π" : p.text); break;
            case Kind::Minus: line.write(" − "); break;
            case Kind::Negative: line.write("−"); break;
            case Kind::Times: line.write("·"); break;
            case Kind::AbsBegin: line.open("|", "|"); break;
            case Kind::SuperscriptBegin:
                if (const std::string small = raised(std::span(pieces).subspan(i + 1)); !small.empty()) {
                    line.write(small);
                    while (pieces[i].kind != Kind::SuperscriptEnd) ++i;
                } else {
                    open_if(line, p.compound, "^");
                }
                break;
            default: open_if(line, p.compound, "√"); break;
        }
    }
    return line.finish();
}

std::string to_latex(const std::vector<Piece>& pieces) {
    Line line;
    for (const Piece& p : pieces) {
        switch (p.kind) {
            case Kind::Number: line.write(latex_number(p.text)); break;
            case Kind::Name: line.write(latex_name(p.text)); break;
            case Kind::Function: line.write(latex_function(p.text)); break;
            case Kind::Plus: line.write(" + "); break;
            case Kind::Minus: line.write(" - "); break;
            case Kind::Negative: line.write("-"); break;
            case Kind::Times: line.write(" \\cdot "); break;
            case Kind::Space: line.write("\\,"); break;
            case Kind::Comma: line.write(", "); break;
            case Kind::Open: line.open("\\left(", "\\right)"); break;
            case Kind::AbsBegin: line.open("\\left|", "\\right|"); break;
            case Kind::FractionBegin: line.open("\\frac{", "}"); break;
            case Kind::FractionOver:
                line.close();
                line.open("{", "}");
                break;
            case Kind::SuperscriptBegin: line.open("^{", "}"); break;
            case Kind::RootBegin: line.open("\\sqrt{", "}"); break;
            case Kind::CasesBegin: line.open("\\begin{cases}", "\\end{cases}"); break;
            case Kind::CasesWhere: line.write(" & \\text{if } "); break;
            case Kind::CasesElse: line.write(" \\le 0 \\\\ "); break;
            case Kind::CasesEnd:
                line.write(" & \\text{otherwise}");
                line.close();
                break;
            case Kind::Truncated: line.write("\\ldots "); break;
            default: line.close(); break;
        }
    }
    return line.finish();
}

}  // namespace normalscope::formulas

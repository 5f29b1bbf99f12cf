#include "ui/typeset/math_layout.h"

#include "ui/kit/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace normalscope {

namespace {

constexpr const char* kPoint = ".";

float em(const MathStyle& style, float share) { return std::round(share * style.em); }

// How many decimals leave the largest entry four digits.
int decimals_of(const Value& value) {
    double largest = 0.0;
    for (int r = 0; r < value.rows; ++r)
        for (int c = 0; c < value.columns; ++c)
            if (const double size = std::abs(value.clean(r, c)); size < 9999.5) largest = std::max(largest, size);
    return largest < 9.9995 ? 3 : largest < 99.995 ? 2 : largest < 999.95 ? 1 : 0;
}

// An entry, split so that its decimal point is where its column has it.
struct Entry {
    std::string whole, rest;
    bool aligned = true;  ///< else all of it is in `whole`, and ends where the column does
};
Entry entry_of(double number, int decimals) {
    if (number == 0.0) return {"0", ""};
    std::string text = std::abs(number) < 9999.5 ? fixed_unless_small(number, decimals) : fixed(number);
    if (text.find_first_of("e\u2014") != std::string::npos) return {std::move(text), "", false};
    const auto point = text.find(kPoint);
    if (point == std::string::npos) return {std::move(text), ""};
    return {text.substr(0, point), text.substr(point)};
}

// How far every column reaches to both sides of the decimal point: the same for 3, 2, 1 or no decimals in sum.
struct Slot {
    float whole, rest;
    float width() const { return whole + rest; }
};
Slot slot_of(const MathStyle& style, int decimals) {
    const auto width = [&](std::string_view text) { return written(style, style.numbers, text, Ink::Plain).width; };
    const float digit = width("0"), all = width("\u2212") + 4.0f * digit + width(kPoint);
    const float rest = decimals > 0 ? width(kPoint) + static_cast<float>(decimals) * digit : 0.0f;
    return {all - rest, rest};
}

MathBox entry_box(const MathStyle& style, const Entry& entry, const Slot& slot, Ink ink, bool struck) {
    const MathBox whole = written(style, style.numbers, entry.whole, ink);
    MathBox box;
    const float end = entry.aligned ? slot.whole : std::max(slot.width(), whole.width);
    MathBox number = whole;
    if (!entry.rest.empty()) number.append(written(style, style.numbers, entry.rest, ink));
    if (struck) strike(style, number, Ink::Dim);
    box.add(number, end - whole.width);
    box.width = std::max(slot.width(), whole.width);
    return box;
}

// From the top of one row to that of the next.
float row_height(const MathStyle& style) { return std::round(style.numbers->FontSize * style.shrink * 1.02f); }

MathBox grid(const MathStyle& style, const std::vector<std::vector<MathBox>>& rows, float gap, bool centred,
             float row) {
    std::vector<float> widths(rows.front().size(), 0.0f);
    for (const auto& cells : rows)
        for (std::size_t c = 0; c < cells.size(); ++c) widths[c] = std::max(widths[c], cells[c].width);
    MathBox box;
    const MathBox& cell = rows.front().front();
    const float middle = -axis(style) + (cell.ascent - cell.descent) / 2;  // the baseline of a single row
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const float y = std::round(middle + (static_cast<float>(r) - static_cast<float>(rows.size() - 1) / 2) * row);
        float x = 0.0f;
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            box.add(rows[r][c],
                    x + (centred ? std::round((widths[c] - rows[r][c].width) / 2) : widths[c] - rows[r][c].width), y);
            x += widths[c] + gap;
        }
    }
    float all = -gap;
    for (const float width : widths) all += width + gap;
    box.width = all;
    return box;
}

}  // namespace

MathBox bracketed_cells(const MathStyle& style, const std::vector<std::vector<MathBox>>& rows, Ink ink) {
    MathBox inside;
    inside.add(grid(style, rows, em(style, 0.5f), true, std::round(1.25f * style.em)), em(style, 0.12f));
    return bracketed(style, inside, ink);
}

MathBox value_box(const MathStyle& style, const Value& value, const EntryInk& ink, Ink brackets, int struck) {
    const int decimals = decimals_of(value);
    const Slot slot = slot_of(style, decimals);
    if (value.is_number()) {
        const Entry entry = entry_of(value.clean(0, 0), decimals);
        return written(style, style.upright, entry.whole + entry.rest, ink(0, 0));
    }
    std::vector<std::vector<MathBox>> rows;
    for (int r = 0; r < value.rows; ++r) {
        auto& row = rows.emplace_back();
        for (int c = 0; c < value.columns; ++c) {
            const bool whole = r == 3 && value.clean(r, c) == 1.0;  // w, and what makes it: not a measure
            const Entry entry = whole ? Entry{"1", ""} : entry_of(value.clean(r, c), decimals);
            row.push_back(entry_box(style, entry, slot, ink(r, c), c == struck));
        }
    }
    return bracketed(style, grid(style, rows, em(style, 0.2f), false, row_height(style)), brackets);
}

MathBox value_box(const MathStyle& style, const Value& value, Ink ink) {
    return value_box(style, value, [ink](int, int) { return ink; }, ink);
}

MathBox name_box(const MathStyle& style, Symbol symbol, Meaning meaning) {
    const Ink ink = ink_of(meaning);
    const auto with = [&](const char* letter, const char* subscript) {
        return with_subscript(style, written(style, style.letters, letter, ink), subscript, ink);
    };
    switch (symbol) {
        case Symbol::NObject: return with("n", "obj");
        case Symbol::VObject: return with("v", "obj");
        case Symbol::NWorld: return with("n", meaning == Meaning::Naive ? "naive" : "world");
        case Symbol::VWorld: return with("v", "world");
        case Symbol::M3: return with("M", "3");
        case Symbol::Zero: break;
    }
    return written(style, style.upright, "0", ink);
}

namespace {

MathBox operator_box(const MathStyle& style, const Expression& e, const AsNumber& as_number, Place place) {
    using enum Expression::Kind;
    const Ink ink = ink_of(e.meaning);
    const auto operand = [&](std::size_t i) {
        const Place there = operand_of(place, i);
        MathBox box = expression_box(style, e.operands[i], as_number, there);
        const bool value = as_number(there, e.operands[i]) && e.operands[i].value;
        return needs_parentheses(e.operands[i], e.kind) && !value ? parenthesised(style, box, ink) : box;
    };
    switch (e.kind) {
        case Symbol: return name_box(style, e.symbol, e.meaning);
        case Transpose: return with_superscript(style, operand(0), "T", ink);
        case Inverse: return with_superscript(style, operand(0), "\u22121", ink);
        case Dot:
        case Equals: {
            MathBox box = operand(0);
            box.append(written(style, style.upright, e.kind == Dot ? "·" : "=", Ink::Plain), em(style, 0.25f));
            box.append(operand(1), em(style, 0.25f));
            return box;
        }
        case Product: break;
    }
    MathBox box = operand(0);
    for (std::size_t i = 1; i < e.operands.size(); ++i) box.append(operand(i), em(style, 0.2f));
    return box;
}

}  // namespace

MathBox expression_box(const MathStyle& style, const Expression& e, const AsNumber& as_number, Place place) {
    const bool zero = e.kind == Expression::Kind::Symbol && e.symbol == Symbol::Zero;
    const bool number = !zero && e.value && as_number(place, e);
    MathBox box = number ? value_box(style, *e.value, ink_of(e.meaning)) : operator_box(style, e, as_number, place);
    box.letter = number ? 0.0f : box.letter;
    // Somewhat larger than it looks, so that it is easy to hit.
    const float more = em(style, 0.1f);
    box.parts.push_back({{-more, -box.ascent - more},
                         {box.width + more, box.descent + more},
                         place,
                         e.kind,
                         e.symbol,
                         e.meaning,
                         number,
                         e.value.has_value() && !zero});
    return box;
}

namespace {
MathBox equals_sign(const MathStyle& style) { return written(style, style.upright, "=", Ink::Plain); }
float beside_sign(const MathStyle& style) { return em(style, 0.3f); }
float width_of(const MathStyle& style, float left, float right) {
    return left + right + equals_sign(style).width + 2 * beside_sign(style);
}
}  // namespace

float width_of(const MathStyle& style, const Equation& e) { return width_of(style, e.left.width, e.right.width); }

std::vector<AlignedEquation> aligned(const MathStyle& style, std::span<const Equation> equations, float width) {
    std::vector<AlignedEquation> result;
    for (std::size_t first = 0; first < equations.size();) {
        float left = equations[first].left.width, right = equations[first].right.width;
        std::size_t end = first + 1;
        for (; end < equations.size(); ++end) {
            const float wider_left = std::max(left, equations[end].left.width),
                        wider_right = std::max(right, equations[end].right.width);
            if (width_of(style, wider_left, wider_right) > width) break;
            left = wider_left;
            right = wider_right;
        }
        for (std::size_t i = first; i < end; ++i) {
            AlignedEquation line;
            line.sign = left + beside_sign(style);
            line.box.add(equations[i].left, left - equations[i].left.width);
            line.box.add(equals_sign(style), line.sign);
            line.box.append(equations[i].right, beside_sign(style));
            result.push_back(std::move(line));
        }
        first = end;
    }
    return result;
}

}  // namespace normalscope

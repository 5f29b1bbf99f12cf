#include "ui/typeset/formula_box.h"

#include "ui/typeset/math_shapes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace normalscope {

namespace {

using Kind = formulas::Piece::Kind;

// What stands between two possible line breaks.
struct Chunk {
    MathBox box;
    bool term = false;  // begins with an operator: better to break here
    float gap = 0.0f;   // before it, within a line
};

// A bracket, fraction, root or exponent that is being filled.
struct Level {
    Kind opened = Kind::Open;
    int script = 0;              // how deep in exponents
    std::vector<MathBox> parts;  // a fraction's numerator; the rows of cases
    std::vector<Chunk> above{};  // a fraction's numerator, where it is too wide for one
    bool compound = false, compound_below = false;
    std::vector<Chunk> row{{}};
    float last_ascent = 0.0f;  // of what an exponent would stand at

    MathBox joined() const {
        MathBox box;
        for (const Chunk& c : row) box.append(c.box, box.width > 0.0f ? c.gap : 0.0f);
        return box;
    }
};

// Works on a stack of its own, as whoever writes the pieces does.
class Setter {
public:
    Setter(const MathStyle& style, float width) : style_(style), width_(width) { levels_.emplace_back(); }

    std::vector<Chunk> run(std::span<const formulas::Piece> pieces) {
        for (const formulas::Piece& p : pieces) {
            if (p.kind == Kind::Truncated) break;
            put(p);
            last_ = p.kind;
        }
        whole = pieces.empty() || pieces.back().kind != Kind::Truncated;
        while (levels_.size() > 1) close();
        return std::move(levels_.back().row);
    }

    bool whole = true;

private:
    Level& level() { return levels_.back(); }
    float em() const { return style_.em * (levels_.back().script > 0 ? 0.7f : 1.0f); }
    float share(float of_em) const { return std::round(of_em * em()); }

    // Exponents have a font of their own size; an exponent's exponents must do with that scaled.
    MathBox glyphs(const std::string& text, bool italic) const {
        MathStyle style = style_;
        const int script = levels_.back().script;
        for (int i = italic ? 0 : 1; i < std::min(script, 3); ++i) style.shrink *= 0.7f;
        const ImFont* font = italic ? style.letters : script > 0 ? style.script : style.upright;
        return written(style, font, text, Ink::Plain);
    }
    void append(const MathBox& box, float gap = 0.0f) {
        level().last_ascent = box.ascent;
        level().row.back().box.append(box, gap);
    }
    void append(const std::string& text, bool italic, float gap = 0.0f) { append(glyphs(text, italic), gap); }
    void next_chunk(bool term, float gap) { level().row.push_back({{}, term, gap}); }
    void open(Kind kind, bool compound = false) {
        const int script = level().script + (kind == Kind::SuperscriptBegin ? 1 : 0);
        levels_.push_back({.opened = kind, .script = script, .parts = {}, .compound = compound});
    }

    void put(const formulas::Piece& p) {
        switch (p.kind) {
            case Kind::Number: return number(p.text);
            case Kind::Name:
                if (p.text == "pi") return append("π", false);
                return append(p.text, p.text.size() == 1, share(0.03f));
            case Kind::Function: return append(p.text, false, share(0.03f));
            case Kind::Plus:
            case Kind::Minus:
                next_chunk(true, share(0.22f));
                append(p.kind == Kind::Plus ? "+" : "−", false);
                level().row.back().box.width += share(0.22f);
                return;
            case Kind::Negative: return append("−", false);
            case Kind::Times:
                next_chunk(false, share(0.1f));
                append("·", false);
                level().row.back().box.width += share(0.1f);
                return;
            case Kind::Space: return next_chunk(false, share(0.2f));
            case Kind::Comma: append(",", false); return next_chunk(false, share(0.2f));
            case Kind::FractionOver:
            case Kind::CasesWhere:
            case Kind::CasesElse:
                level().parts.push_back(level().joined());
                level().above = std::move(level().row);
                level().compound_below = p.compound;
                level().row.assign(1, {});
                return;
            case Kind::Close:
            case Kind::AbsEnd:
            case Kind::FractionEnd:
            case Kind::SuperscriptEnd:
            case Kind::RootEnd:
            case Kind::CasesEnd: return close();
            case Kind::Truncated: return;
            default:
                // Before a factor in brackets there may be a break, but not after a mere number.
                if (p.kind == Kind::Open && last_ != Kind::Number && last_ != Kind::Negative &&
                    last_ != Kind::Function && !level().row.back().box.texts.empty())
                    next_chunk(false, share(0.03f));
                open(p.kind, p.compound);
        }
    }

    void number(const std::string& text) {
        const std::size_t e = text.find('e');
        append(text.substr(0, e), false, share(0.03f));
        if (e == std::string::npos) return;
        append("·10", false);
        open(Kind::SuperscriptBegin);
        std::string exponent = text.substr(e + 1);
        if (exponent.starts_with('+')) exponent.erase(0, 1);
        if (exponent.starts_with('-')) exponent.replace(0, 1, "−");
        append(exponent, false);
        close();
    }

    void close() {
        Level done = std::move(levels_.back());
        levels_.pop_back();
        MathBox inside = done.joined();
        switch (done.opened) {
            case Kind::Open: return append(parenthesised(style_, inside, Ink::Plain));
            case Kind::AbsBegin: return append(between_bars(inside));
            case Kind::FractionBegin:
                if (levels_.size() == 1 && !done.parts.empty() && done.parts[0].width > width_)
                    return append_in_line(std::move(done), inside);
                return append(done.parts.empty() ? inside : fraction_box(pen(), done.parts[0], inside), share(0.06f));
            case Kind::RootBegin: return append(root_box(pen(), inside), share(0.06f));
            case Kind::CasesBegin: done.parts.push_back(std::move(inside)); return append(cases(done.parts));
            default: return raise(inside);
        }
    }

    // A fraction that is wider than a line: a b c/(d + e), which can be broken.
    void append_in_line(Level fraction, const MathBox& below) {
        if (fraction.compound) {
            append(parenthesised(style_, fraction.parts[0], Ink::Plain));
        } else {
            level().row.back().box.append(fraction.above.front().box);
            level().row.insert(level().row.end(), std::make_move_iterator(fraction.above.begin() + 1),
                               std::make_move_iterator(fraction.above.end()));
        }
        append("/", false, share(0.06f));
        append(fraction.compound_below ? parenthesised(style_, below, Ink::Plain) : below, share(0.03f));
    }

    void raise(const MathBox& exponent) {
        MathBox& base = level().row.back().box;
        const float ascent = level().last_ascent, size = em();
        const float up = ascent > 1.2f * size ? ascent - std::round(0.30f * size) : std::round(0.40f * size);
        base.add(exponent, base.width + share(0.06f), -up - exponent.descent + std::min(exponent.descent, share(0.2f)));
        base.width += share(0.02f);
    }

    MathBox between_bars(const MathBox& inside) const {
        MathBox box;
        const float gap = share(0.14f), more = share(0.04f);
        box.add(inside, 2 * gap);
        const float right = box.width + gap;
        for (const float x : {gap, right})
            box.strokes.push_back(straight(pen(), {x, -inside.ascent - more}, {x, inside.descent + more}));
        box.width = right + gap;
        return box;
    }

    // a where c ≤ 0, b elsewhere: parts are a, c, b.
    MathBox cases(const std::vector<MathBox>& parts) const {
        const auto word = [&](const char* text) { return written(style_, style_.script, text, Ink::Plain); };
        std::vector<MathBox> rows(2);
        rows[0] = parts[0];
        if (parts.size() > 1) {
            rows[0].append(word("where"), share(0.6f));
            rows[0].append(parts[1], share(0.3f));
            rows[0].append(word("≤ 0"), share(0.3f));
        }
        if (parts.size() > 2) rows[1] = parts[2];
        rows[1].append(word("elsewhere"), share(0.6f));
        MathBox box;
        const float wide = share(0.4f), y = -std::round(0.34f * em()), half = share(0.1f);
        box.add(rows[0], wide + share(0.1f), y - half - rows[0].descent);
        box.add(rows[1], wide + share(0.1f), y + half + rows[1].ascent);
        for (const float end : {-box.ascent, box.descent}) {
            const float x = std::round(wide / 2);
            box.strokes.push_back({{ImVec2(wide, end), ImVec2(x - share(0.1f), end), ImVec2(x + share(0.15f), y),
                                    ImVec2(share(0.05f), y)},
                                   true,
                                   style_.weight,
                                   Ink::Plain});
        }
        return box;
    }

    Pen pen() const { return {em(), style_.weight}; }

    const MathStyle& style_;
    float width_;
    Kind last_ = Kind::Open;  // of the pieces so far
    std::vector<Level> levels_;
};

}  // namespace

FormulaBox formula_box(const MathStyle& style, std::span<const formulas::Piece> pieces, float width,
                       std::size_t most_lines) {
    Setter setter(style, 0.9f * width);
    const std::vector<Chunk> chunks = setter.run(pieces);
    FormulaBox result;
    result.whole = setter.whole;
    MathBox line;
    float y = 0.0f, last_descent = 0.0f, last_end = 0.0f;
    bool first_line = true;
    const float indent = std::round(0.6f * style.em);
    const auto end_line = [&] {
        if (!first_line) y += std::round(last_descent + line.ascent + 0.25f * style.em);
        last_descent = line.descent;
        last_end = line.width + (first_line ? 0.0f : indent);
        result.box.add(line, first_line ? 0.0f : indent, y);
        if (last_end > width) result.whole = false;
        first_line = false;
        line = {};
    };
    for (std::size_t i = 0; i < chunks.size();) {
        // A term as a whole where it fits on a line of its own; or else factor by factor.
        std::size_t end = i + 1;
        float wide = chunks[i].box.width;
        const bool begins_term = i == 0 || chunks[i].term;
        for (; begins_term && end < chunks.size() && !chunks[end].term; ++end)
            wide += chunks[end].gap + chunks[end].box.width;
        if (wide > width - indent) end = i + 1, wide = chunks[i].box.width;
        const float room = width - (first_line ? 0.0f : indent);
        if (line.width > 0.0f && line.width + chunks[i].gap + wide > room) {
            end_line();
            if (++result.lines > most_lines) {
                --result.lines;
                result.whole = false;
                MathBox dots = written(style, style.script, "…", Ink::Dim);
                result.box.add(dots, std::min(last_end + indent / 2, width - dots.width), y);
                return result;
            }
        }
        for (; i < end; ++i) line.append(chunks[i].box, line.width > 0.0f ? chunks[i].gap : 0.0f);
    }
    end_line();
    if (!setter.whole) result.box.add(written(style, style.script, " …", Ink::Dim), last_end, y);
    return result;
}

MathBox derivative_name(const MathStyle& style, std::size_t which) {
    MathBox f = written(style, style.letters, "f", Ink::Plain);
    if (which == 0) return f;
    MathBox box = written(style, style.upright, "∂", Ink::Plain);
    box.append(f);
    box.append(written(style, style.upright, "/∂", Ink::Plain), std::round(0.06f * style.em));
    box.append(written(style, style.letters, formulas::kVariableNames.substr(which - 1, 1), Ink::Plain));
    return box;
}

}  // namespace normalscope

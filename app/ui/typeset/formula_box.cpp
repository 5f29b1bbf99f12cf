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

constexpr std::size_t kMostLinesInside = 6;  // a bracket

// What stands between two possible line breaks.
struct Chunk {
    MathBox box;
    bool term = false;  // begins with an operator: better to break here
    float gap = 0.0f;   // before it, within a line
};

FormulaBox in_lines(const MathStyle& style, const std::vector<Chunk>& chunks, float width, std::size_t most_lines) {
    FormulaBox result;
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
    return result;
}

// A bracket, fraction, root or exponent that is being filled.
struct Level {
    Kind opened = Kind::Open;
    int script = 0;              // how deep in exponents
    float room = 0.0f;           // for what it holds, within a line
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
    Setter(const MathStyle& style, float width) : style_(style), width_(width) { levels_.push_back({.room = width}); }

    std::vector<Chunk> run(std::span<const formulas::Piece> pieces) {
        for (const formulas::Piece& p : pieces) {
            if (p.kind == Kind::Truncated) break;
            put(p);
            last_ = p.kind;
        }
        while (levels_.size() > 1) close();
        if (pieces.empty() || pieces.back().kind != Kind::Truncated) return std::move(levels_.back().row);
        whole = false;
        append(written(style_, style_.script, " …", Ink::Dim));
        return std::move(levels_.back().row);
    }

    bool whole = true, broken_inside = false;

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
    MathBox word(const char* text) const { return written(style_, style_.script, text, Ink::Plain); }
    void append(const MathBox& box, float gap = 0.0f) {
        level().last_ascent = box.ascent;
        level().row.back().box.append(box, gap);
    }
    void append(const std::string& text, bool italic, float gap = 0.0f) { append(glyphs(text, italic), gap); }
    void next_chunk(bool term, float gap) { level().row.push_back({{}, term, gap}); }
    void open(Kind kind, bool compound = false) {
        const int script = level().script + (kind == Kind::SuperscriptBegin ? 1 : 0);
        const float around = kind == Kind::Open ? 1.3f : 0.6f;  // brackets that are high are also wide
        const float room = level().room - level().row.back().box.width - share(around);
        levels_.push_back({.opened = kind, .script = script, .room = room, .parts = {}, .compound = compound});
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
                level().parts.push_back(part_before(p.kind));
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
        const bool breaks =
            done.opened == Kind::Open || done.opened == Kind::AbsBegin || done.opened == Kind::CasesBegin;
        MathBox inside = breaks ? fitted(done, done.room) : done.joined();
        switch (done.opened) {
            case Kind::Open: return append(parenthesised(style_, inside, Ink::Plain));
            case Kind::AbsBegin: return append(between_bars(inside));
            case Kind::FractionBegin:
                if (levels_.size() == 1 && !done.parts.empty() && done.parts[0].width > width_)
                    return append_in_line(std::move(done), inside);
                return append(done.parts.empty() ? inside : fraction_box(pen(), done.parts[0], inside), share(0.06f));
            case Kind::RootBegin: return append(root_box(pen(), inside), share(0.06f));
            case Kind::CasesBegin: done.parts.push_back(std::move(inside)); return append(cases(done.parts, done.room));
            default: return raise(inside);
        }
    }

    MathBox part_before(Kind next) {
        if (next == Kind::FractionOver) return level().joined();
        if (next == Kind::CasesWhere) return fitted(level(), level().room);
        next_chunk(false, share(0.3f));
        append(word("≤ 0"));
        return fitted(level(), level().room - share(0.9f) - word("where").width);
    }

    // What is inside a bracket, over several lines where one has no room for it.
    MathBox fitted(const Level& inside, float room) {
        MathBox box = inside.joined();
        if (box.width <= room || inside.script > 0) return box;
        broken_inside = true;
        const FormulaBox lines = in_lines(style_, inside.row, room, kMostLinesInside);
        whole = whole && lines.whole;
        MathBox centred;  // what stands beside it is beside its middle
        centred.add(lines.box, 0.0f, std::round((lines.box.ascent - lines.box.descent) / 2 - axis(style_)));
        return centred;
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

    // a where c ≤ 0, b elsewhere: parts are a, c ≤ 0, b. What has no room beside its value stands below it.
    MathBox cases(const std::vector<MathBox>& parts, float room) const {
        const float gap = share(0.6f);
        const auto with = [&](MathBox value, const MathBox& when) {
            if (value.width + gap + when.width <= room)
                value.append(when, gap);
            else
                value.add(when, gap, value.descent + share(0.1f) + when.ascent);
            return value;
        };
        std::vector<MathBox> rows(2);
        rows[0] = parts[0];
        if (parts.size() > 1) {
            MathBox where = word("where");
            where.append(parts[1], share(0.3f));
            rows[0] = with(std::move(rows[0]), where);
        }
        rows[1] = with(parts.size() > 2 ? parts[2] : MathBox{}, word("elsewhere"));
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
    FormulaBox result = in_lines(style, chunks, width, most_lines);
    result.whole = result.whole && setter.whole;
    result.broken_inside = setter.broken_inside;
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

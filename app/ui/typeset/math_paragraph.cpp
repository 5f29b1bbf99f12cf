// Sentences with mathematics in them: core/base/math_text.h says how it is written.

#include "core/base/math_text.h"
#include "ui/typeset/math_layout.h"
#include "ui/typeset/math_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr std::array<std::string_view, 13> kOperators{"=", "·", "×", "∘", "+", "−", "→", "⊥", "<", ">", "≤", "≥", "≠"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// A word, up to the next space.
struct Word {
    MathBox box;
    bool joins = false;  ///< it is an operator, which stands with what is on both sides of it
    bool any = false;
};

class SentenceSetter {
public:
    SentenceSetter(MathStyle style, WordInks inks) : style_(style), inks_(std::move(inks)) {
        em_ = style.script->FontSize * style.shrink / 1.362f;
    }

    std::vector<Word> words(const MathLine& line) {
        words_.assign(1, {});
        for (const MathPart& part : line) add(part);
        return std::move(words_);
    }
    // Not to be broken.
    MathBox row(const MathLine& line) const {
        SentenceSetter inner(style_, inks_);
        MathBox box;
        bool first = true;
        for (const Word& word : inner.words(line)) {
            if (!std::exchange(first, false)) box.width += space();
            box.append(word.box);
        }
        return box;
    }
    float space() const { return written(style_, style_.script, " ", inks_.words).width; }

private:
    float share(float of_em) const { return std::round(of_em * em_); }
    Pen pen() const { return {em_, style_.weight, inks_.words}; }
    MathStyle smaller() const {
        MathStyle style = style_;
        if (style.script == style.subscript_in_text) style.shrink *= 0.8f;
        style.script = style.subscript_in_text;
        style.letters_in_text = nullptr;
        style.em = style.script->FontSize * style.shrink / 1.362f;
        return style;
    }
    void put(const MathBox& box) { words_.back().box.append(box), words_.back().any = true; }

    void add(const MathPart& part) {
        if (part.kind == MathPart::Kind::Words) return add_words(part.words);
        put(box_of(part));
    }

    void add_words(std::string_view text) {
        while (!text.empty()) {
            const auto end = std::min(text.find(' '), text.size());
            if (end > 0) {
                words_.back().joins = !words_.back().any && std::ranges::count(kOperators, text.substr(0, end)) > 0;
                put(letters(text.substr(0, end)));
            }
            if (end == text.size()) return;
            words_.emplace_back();
            text.remove_prefix(end + 1);
        }
    }

    // Names of one letter are slanted: in a sentence, "a" and "I" are no names.
    MathBox letters(std::string_view word) const {
        MathBox box;
        std::size_t from = 0;
        const auto flush = [&](std::size_t to) {
            if (to > from) box.append(written(style_, style_.script, word.substr(from, to - from), inks_.words));
            from = to;
        };
        for (std::size_t i = 0; style_.letters_in_text && i < word.size(); ++i) {
            if (!is_letter(word[i])) continue;
            std::size_t end = i;
            while (end < word.size() && is_letter(word[end])) ++end;
            if (end == i + 1 && is_name(word, i)) {
                flush(i);
                box.append(written(style_, style_.letters_in_text, word.substr(i, 1), inks_.words));
                from = end;
            }
            i = end - 1;
        }
        flush(word.size());
        return box;
    }
    bool is_name(std::string_view word, std::size_t at) const {
        const char next = at + 1 < word.size() ? word[at + 1] : ' ', before = at > 0 ? word[at - 1] : ' ';
        const bool abbreviation = before == '.' || (next == '.' && at + 2 < word.size());
        const bool genitive = before == '\'' || (at >= 3 && word.substr(at - 3, 3) == "’");
        const bool key = next >= '0' && next <= '9';
        // 2x is a product, but lesson 1b and 3D are not.
        const bool number = !style_.formula && before >= '0' && before <= '9' && (word[at] < 'x' || word[at] > 'z');
        const bool article = !style_.formula && std::string_view("aAI").find(word[at]) != std::string_view::npos;
        return !abbreviation && !genitive && !key && !number && !article;
    }

    MathBox box_of(const MathPart& part) const {
        switch (part.kind) {
            case MathPart::Kind::Words: return letters(part.words);
            case MathPart::Kind::Scripted: return scripted(part);
            case MathPart::Kind::Parentheses: {
                MathStyle style = style_;
                style.em = em_;
                return parenthesised(style, row(part.lines[0]), inks_.words);
            }
            case MathPart::Kind::Bold: return bold(row(part.lines[0]));
            case MathPart::Kind::Fraction: {
                const SentenceSetter inner(smaller(), inks_);
                return fraction_box(pen(), inner.row(part.lines[0]), inner.row(part.lines[1]));
            }
            case MathPart::Kind::Root: return root_box(pen(), row(part.lines[0]));
            case MathPart::Kind::Matrix: break;
        }
        MathStyle small = smaller();
        const SentenceSetter inner(small, inks_);
        std::vector<std::vector<MathBox>> rows;
        for (std::size_t i = 0; i < part.lines.size(); ++i) {
            if (i % part.columns == 0) rows.emplace_back();
            rows.back().push_back(inner.row(part.lines[i]));
        }
        return bracketed_cells(small, rows, inks_.words);
    }

    // As heavy as it gets by printing twice: other scripts have no bold letters here.
    MathBox bold(const MathBox& box) const {
        MathBox twice = box;
        twice.add(box, std::max(1.0f, share(0.04f)));
        return twice;
    }

    MathBox scripted(const MathPart& part) const {
        const std::string symbol = symbol_name(part);
        const bool stands_out = !inks_.stands_out.empty() && symbol == inks_.stands_out;
        WordInks inks = inks_;
        if (!symbol.empty()) inks.words = ink_of(symbol);
        const SentenceSetter base(style_, inks), script(smaller(), inks), above(smaller(), inks_);
        MathBox box = base.row(part.lines[0]);
        const bool group = part.lines[0].size() == 1 && part.lines[0][0].kind != MathPart::Kind::Words;
        const float end = box.width, base_ascent = box.ascent;
        if (!part.lines[1].empty()) box.add(script.row(part.lines[1]), end, share(0.17f));
        if (!part.lines[2].empty()) {
            const MathBox raised = above.row(part.lines[2]);
            const float up = group ? base_ascent - std::round(0.72f * raised.ascent) : share(0.38f);
            box.add(raised, end + share(0.05f), -up);
        }
        box.width += share(0.03f);
        return stands_out ? bold(box) : box;
    }
    Ink ink_of(const std::string& symbol) const {
        if (!inks_.stands_out.empty() && symbol != inks_.stands_out) return inks_.words;
        if (symbol == "n_naive") return Ink::Naive;
        if (symbol == "n_world") return normalscope::ink_of(inks_.n_world);
        return symbol.starts_with("v_") ? Ink::Tangent : inks_.words;
    }

    MathStyle style_;
    WordInks inks_;
    float em_;
    std::vector<Word> words_;
};

}  // namespace

MathBox paragraph(const MathStyle& style, std::string_view text, float width, const WordInks& inks) {
    SentenceSetter setter(style, inks);
    const float space = setter.space();
    const std::vector<Word> words = setter.words(read_math(text));
    const float pitch = std::round(style.script->FontSize * style.shrink * 1.04f);
    MathBox box, line;
    float y = 0.0f, last_descent = 0.0f;
    bool first = true;
    const auto end_line = [&] {
        if (!first) y += std::max(pitch, std::round(last_descent + line.ascent + 0.15f * pitch));
        first = false;
        last_descent = line.descent;
        box.add(line, 0.0f, y);
        line = {};
    };
    for (std::size_t i = 0; i < words.size();) {
        // n · t = 0 is not broken at its signs, as long as a line has room for it.
        MathBox word = words[i].box;
        for (++i; i < words.size() && (words[i].joins || words[i - 1].joins); ++i) {
            if (word.width + space + words[i].box.width > width) break;
            word.append(words[i].box, space);
        }
        if (line.width > 0.0f && line.width + space + word.width > width) end_line();
        line.append(word, line.width > 0.0f ? space : 0.0f);
    }
    end_line();
    return box;
}

MathBox paragraph(const MathStyle& style, std::string_view text, float width, Ink ink, Meaning n_world) {
    return paragraph(style, text, width, WordInks{ink, n_world, {}});
}

}  // namespace normalscope

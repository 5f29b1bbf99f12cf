#pragma once

// The text of a mesh file, line by line and word by word. By hand: of a large mesh's capture, a library's reading takes a
// quarter. Only the readers of mesh files include this.

#include "core/base/decimal.h"
#include "core/base/text.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace normalscope {

/// Without the byte order mark that some editors put before UTF-8.
inline std::string_view without_mark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    return text;
}

/// As much of a word of a file as fits a message, in quotes: printable, and of one line.
inline std::string in_quotes(std::string_view word) {
    constexpr std::size_t kLongest = 30;
    std::string text(word.substr(0, kLongest));
    std::ranges::replace_if(text, [](char c) { return c < ' ' || c > '~'; }, '?');
    return '"' + text + (word.size() > kLongest ? "…" : "") + '"';
}

/// What a `#` and a backslash at a line's end are.
enum class LineSyntax {
    Plain,
    Obj  ///< the former begins a comment, the latter continues a statement in the next line
};

/// A line ends with \n, \r\n or \r. Words are parted by spaces and tabs.
class Words {
public:
    explicit Words(std::string_view text, LineSyntax syntax = LineSyntax::Plain)
        : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), obj_(syntax == LineSyntax::Obj) {}

    bool at_end() const { return at_ == end_; }
    std::string_view rest() const { return {at_, end_}; }
    /// The place's line, counted from 1.
    std::size_t line() const { return line_at({begin_, end_}, static_cast<std::size_t>(at_ - begin_)); }
    static std::size_t line_at(std::string_view text, std::size_t place) {
        std::size_t line = 1;
        for (std::size_t i = 0; i < std::min(place, text.size()); ++i)
            if (text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'))) ++line;
        return line;
    }

    void skip_line() {
        bool comment = !obj_;
        while (at_ < end_ && !ends_line(*at_)) {
            comment = comment || *at_ == '#';
            at_ += comment ? 1 : std::max<std::ptrdiff_t>(continuation(), 1);
        }
        if (at_ == end_) return;
        const bool two = *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n';
        at_ += two ? 2 : 1;
    }
    /// The line's next word, empty where there is none.
    std::string_view next() {
        skip_blanks();
        const char* const begin = at_;
        while (at_ < end_ && !ends_word()) ++at_;
        return {begin, at_};
    }
    /// On to the next word, in this line or a later one.
    void skip_empty_lines() {
        for (skip_blanks(); at_ < end_ && ends_line(*at_); skip_blanks()) ++at_;
    }
    /// Whether no word follows in this line.
    bool line_is_over() {
        skip_blanks();
        return word_is_over();
    }
    bool word_is_over() const { return at_ == end_ || ends_word(); }
    /// Goes past this character, if it is the next one.
    bool take(char c) {
        const bool found = at_ < end_ && *at_ == c;
        at_ += found ? 1 : 0;
        return found;
    }
    /// A whole number, or 0 where no digit stands; false for a sign alone. What is too large for any file's index stays so.
    bool index(std::int64_t& to) {
        constexpr std::int64_t kBeyondAll = std::int64_t{1} << 40;
        const bool negative = take('-'), has_sign = negative || take('+');
        const char* const digits = at_;
        for (to = 0; at_ < end_ && *at_ >= '0' && *at_ <= '9'; ++at_)
            if (to < kBeyondAll) to = 10 * to + (*at_ - '0');
        if (negative) to = -to;
        return !has_sign || at_ > digits;
    }
    /// Such as -1.5e3, in this line; false where the next word is no such number.
    bool number(double& to) {
        skip_blanks();
        if (at_ < end_ && *at_ == '+') ++at_;
        const std::size_t length = read_decimal({at_, end_}, to);
        at_ += length;
        return length > 0 && word_is_over();
    }
    bool numbers(glm::dvec3& to) { return number(to.x) && number(to.y) && number(to.z); }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t'; }
    static bool ends_line(char c) { return c == '\n' || c == '\r'; }
    bool ends_word() const {
        return is_blank(*at_) || ends_line(*at_) || (obj_ && (*at_ == '#' || continuation() > 0));
    }
    void skip_blanks() {
        while (at_ < end_ && (is_blank(*at_) || (obj_ && continuation() > 0)))
            at_ += is_blank(*at_) ? 1 : continuation();
    }
    /// Characters of a backslash here and of the line end after it; else 0.
    std::ptrdiff_t continuation() const {
        if (*at_ != '\\' || end_ - at_ < 2 || !ends_line(at_[1])) return 0;
        return at_[1] == '\r' && end_ - at_ > 2 && at_[2] == '\n' ? 3 : 2;
    }

    const char *begin_, *at_, *end_;
    bool obj_;
};

}  // namespace normalscope

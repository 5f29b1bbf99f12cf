#include "core/base/json_position.h"

#include <algorithm>
#include <cctype>

namespace normalscope {

namespace {

/// Walks through JSON that is known to be valid, so that nothing needs to be checked but the end.
class Walker {
public:
    explicit Walker(std::string_view text) : text_(text) {}

    std::size_t find(std::span<const std::string> path) {
        skip_space();
        const std::size_t here = at_;
        if (path.empty() || (peek() != '{' && peek() != '[')) return here;
        const bool object = peek() == '{';
        ++at_;
        for (std::size_t index = 0;; ++index) {
            skip_space();
            if (at_ >= text_.size() || peek() == '}' || peek() == ']') return here;
            std::string key = object ? string() : std::to_string(index);
            if (object) {
                skip_space();
                ++at_;  // the colon
            }
            if (key == path.front()) return find(path.subspan(1));
            skip_value();
            skip_space();
            if (peek() == ',') ++at_;
        }
    }

private:
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip_space() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }
    // Keys with escapes stay as they are written: no path of ours has any.
    std::string string() {
        const std::size_t begin = ++at_;
        while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        const std::size_t end = std::min(at_++, text_.size());
        return std::string(text_.substr(begin, end - begin));
    }
    void skip_value() {
        int depth = 0;
        do {
            skip_space();
            switch (peek()) {
                case '"': string(); break;
                case '{':
                case '[': ++depth, ++at_; break;
                case '}':
                case ']': --depth, ++at_; break;
                case ',':
                case ':': ++at_; break;
                default:
                    while (at_ < text_.size() && std::string_view(",:]} \t\r\n").find(text_[at_]) == std::string::npos)
                        ++at_;
            }
        } while (depth > 0 && at_ < text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

int json_line(std::string_view text, std::span<const std::string> path) {
    const std::size_t at = std::min(Walker(text).find(path), text.size());
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace normalscope

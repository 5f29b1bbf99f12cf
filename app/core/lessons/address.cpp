#include "core/lessons/address.h"

#include "core/base/error.h"
#include "core/base/html.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace normalscope {

namespace {

bool is_address(std::string_view text) {
    constexpr std::array<std::string_view, 4> kBeginnings{"#", "http://", "https://", "file://"};
    return std::ranges::any_of(kBeginnings, [&](std::string_view beginning) { return text.starts_with(beginning); });
}

std::string_view without_space_around(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
    return text.substr(0, text.find_last_not_of(kSpace) + 1);
}

// "%23" is "#"; what is no such code stays as it is.
std::string decoded(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        unsigned char letter = 0;
        const bool code = text.size() > 2 && text[0] == '%';
        const char *from = text.data() + 1, *to = text.data() + 3;
        if (code && std::from_chars(from, to, letter, 16).ptr == to) {
            result += static_cast<char>(letter);
            text.remove_prefix(3);
        } else {
            result += text.front();
            text.remove_prefix(1);
        }
    }
    return result;
}

}  // namespace

std::optional<std::string> name_of_address(std::string_view text) {
    text = without_space_around(text);
    if (!is_address(text)) return std::nullopt;
    const auto mark = text.find('#');
    std::string name = mark == text.npos ? "" : decoded(text.substr(mark + 1));
    if (name.empty()) throw InputError("address", "ends with an empty #; copy it from the page by Ctrl+L");
    return name;
}

std::string address_of_step(const std::string& lesson, std::size_t step) {
    return lesson + "/" + std::to_string(step + 1);
}

std::string frame_html(std::string_view address, std::string_view title) {
    const auto mark = address.find('#');
    const std::string_view page =
        mark == address.npos ? "normalscope.html" : address.substr(0, address.find_first_of("?#"));
    const std::string_view shown = mark == address.npos ? address : address.substr(mark + 1);
    return "<iframe src=\"" + html_text(page) + "?panel=0#" + html_text(shown) +
           "\" sandbox=\"allow-scripts allow-downloads\" allow=\"fullscreen; clipboard-write\"\n  width=\"800\" "
           "height=\"500\" title=\"" +
           html_text(title) + "\"></iframe>\n";
}

}  // namespace normalscope

#include "core/base/utf8.h"

#include <algorithm>

namespace normalscope {

std::size_t columns(std::string_view utf8) {
    return static_cast<std::size_t>(
        std::ranges::count_if(utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(std::string_view utf8, std::size_t width) {
    const std::size_t have = columns(utf8);
    return std::string(utf8) + std::string(have < width ? width - have : 0, ' ');
}

std::string in_one_line(std::string_view utf8) {
    std::string line;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const auto byte = static_cast<unsigned char>(utf8[i]);
        const std::string_view rest = utf8.substr(i, 3);
        const bool c1 =
            byte == 0xC2 && rest.size() > 1 && static_cast<unsigned char>(rest[1]) < 0xA0;  // U+0080 to U+009F
        const bool separator = rest == "\u2028" || rest == "\u2029";
        if (byte < ' ' || byte == 0x7F || c1 || separator)
            line += "\uFFFD";
        else
            line += utf8[i];
        i += c1 ? 1 : separator ? 2 : 0;
    }
    return line;
}

std::string shortened(std::string_view utf8, std::size_t most_bytes) {
    constexpr std::string_view kMore = "…";
    if (utf8.size() <= most_bytes) return std::string(utf8);
    std::size_t end = most_bytes - std::min(most_bytes, kMore.size());
    while (end > 0 && (static_cast<unsigned char>(utf8[end]) & 0xC0U) == 0x80U) --end;
    return std::string(utf8.substr(0, end)) + std::string(kMore);
}

}  // namespace normalscope

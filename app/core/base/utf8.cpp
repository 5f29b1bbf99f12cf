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

}  // namespace normalscope

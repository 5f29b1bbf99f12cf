#include "core/base/text.h"

#include <algorithm>

namespace normalscope {

std::string joined(std::span<const std::string> words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : between).append(word);
    return text;
}

std::string alternatives(std::span<const std::string> words) {
    if (words.size() < 2) return joined(words);
    return joined(words.first(words.size() - 1)) + " or " + words.back();
}

std::string counted(std::size_t count, std::string_view one) {
    return std::to_string(count) + " " + std::string(one) + (count == 1 ? "" : "s");
}

std::string in_small_letters(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

bool has_ending(std::string_view name, std::string_view lower) {
    return name.size() >= lower.size() && is_word(name.substr(name.size() - lower.size()), lower);
}

}  // namespace normalscope

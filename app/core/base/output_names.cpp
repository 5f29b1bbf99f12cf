#include "core/base/output_names.h"

#include "core/base/text.h"

#include <optional>

namespace normalscope {

namespace {

struct Place {
    std::size_t width = 0, length = 0;  // of the number at least, and of "%03d"
};

std::optional<Place> place_at(const std::string& pattern, std::size_t at) {
    std::size_t end = at + 1;
    while (end < pattern.size() && end < at + 3 && pattern[end] >= '0' && pattern[end] <= '9') ++end;
    if (end == pattern.size() || pattern[end] != 'd') return std::nullopt;
    const std::string digits = pattern.substr(at + 1, end - at - 1);
    return Place{digits.empty() ? 0 : std::stoul(digits), end + 1 - at};
}

}  // namespace

bool is_video(const std::filesystem::path& file) {
    const std::string name = file.string();
    return has_ending(name, ".gif") || has_ending(name, ".mp4") || has_ending(name, ".webm");
}

std::size_t places_for_numbers(const std::string& pattern) {
    std::size_t places = 0;
    for (std::size_t at = 0; at < pattern.size(); ++at)
        if (pattern[at] == '%' && pattern.compare(at, 2, "%%") == 0)
            ++at;
        else if (pattern[at] == '%' && place_at(pattern, at))
            ++places;
    return places;
}

std::filesystem::path numbered(const std::string& pattern, std::size_t i, std::size_t columns) {
    const bool two = places_for_numbers(pattern) == 2;
    std::string name;
    bool first = true;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::optional<Place> place = pattern[at] == '%' ? place_at(pattern, at) : std::nullopt;
        if (!place) {
            at += pattern.compare(at, 2, "%%") == 0 ? 1 : 0;
            name += pattern[at++];
            continue;
        }
        std::string number = std::to_string(!two ? i : first ? i / columns : i % columns);
        if (number.size() < place->width) number.insert(0, place->width - number.size(), '0');
        name += number;
        first = false;
        at += place->length;
    }
    return name;
}

std::string literally(const std::string& name) {
    std::string pattern;
    for (const char c : name) pattern += c == '%' ? "%%" : std::string(1, c);
    return pattern;
}

}  // namespace normalscope

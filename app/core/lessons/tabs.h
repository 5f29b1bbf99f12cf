#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// A tab beside the picture. `--tab` and its help, a lesson's key "tab" and the interface all go by this list; what each
/// draws is in ui/interface.cpp.
struct Tab {
    std::string_view name;
    const char* label;
    const char* about;
    bool at_first;  ///< in the panel's row; the others come by a press
};
inline constexpr std::array<Tab, 5> kTabs{
    {{"derivation", "Derivation", "Why the inverse transpose? Line by line, with the scene's numbers. (D)", true},
     {"stack", "Stack", "The transforms one by one: their inverses, their products, and the wrong orders.", true},
     {"maps", "Maps", "The classes of maps, and what each does to normals.", false},
     {"error", "Error", "How far off the naive rule is: over the surface, and against the stretch.", true},
     {"ray", "Ray", "What a ray tracer does with one ray, step by step.", false}}};

inline std::vector<std::string> tab_names() {
    std::vector<std::string> names;
    for (const Tab& tab : kTabs) names.emplace_back(tab.name);
    return names;
}

/// The check and the last column of M are the last two.
inline constexpr std::size_t kLinesWithArrows = 10, kDerivationPassages = 12;

/// What else there is to ask of the first of them, for a message about one that does not exist.
inline std::string tabs_of_the_derivation() {
    return "derivation#1 to derivation#" + std::to_string(kDerivationPassages) +
           " are at its lines, and derivation:numbers has numbers in place of names";
}

/// "derivation:numbers", and "derivation#5:numbers", have numbers in place of names.
inline constexpr std::string_view kNumbersInTab = ":numbers";
inline bool numbers_in_tab(std::string_view tab) {
    return tab.starts_with(kTabs[0].name) && tab.ends_with(kNumbersInTab);
}
inline std::string_view without_numbers(std::string_view tab) {
    if (numbers_in_tab(tab)) tab.remove_suffix(kNumbersInTab.size());
    return tab;
}

inline constexpr std::string_view kLineInTab = "derivation#";
/// The line, counted from 0, that "derivation#5" asks for; empty for anything else.
inline std::optional<std::size_t> line_of_tab(std::string_view tab) {
    if (!tab.starts_with(kLineInTab)) return std::nullopt;
    const std::string digits(tab.substr(kLineInTab.size()));
    if (digits.empty() || digits.size() > 2 || digits.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    const std::size_t line = std::stoul(digits);
    return line >= 1 && line <= kDerivationPassages ? std::optional(line - 1) : std::nullopt;
}

}  // namespace normalscope

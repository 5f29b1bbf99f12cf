#pragma once

#include <array>
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
};
inline constexpr std::array<Tab, 5> kTabs{
    {{"derivation", "Derivation", "Why the inverse transpose? Line by line, with the scene's numbers. (D)"},
     {"stack", "Stack", "The transforms one by one: their inverses, their products, and the wrong orders."},
     {"maps", "Maps", "The classes of maps, and what each does to normals."},
     {"error", "Error", "How far off the naive rule is: over the surface, and against the stretch."},
     {"ray", "Ray", "What a ray tracer does with one ray, step by step."}}};

inline std::vector<std::string> tab_names() {
    std::vector<std::string> names;
    for (const Tab& tab : kTabs) names.emplace_back(tab.name);
    return names;
}

}  // namespace normalscope

#include "ui/kit/own_keys.h"

#include <imgui.h>

namespace normalscope {

std::string with_own_keys(std::string_view words) {
    constexpr std::string_view kControl = "Ctrl", kCommand = "Cmd";
    std::string own(words);
    if (!ImGui::GetIO().ConfigMacOSXBehaviors) return own;
    for (auto at = own.find(kControl); at != std::string::npos; at = own.find(kControl, at))
        own.replace(at, kControl.size(), kCommand);
    return own;
}

}  // namespace normalscope

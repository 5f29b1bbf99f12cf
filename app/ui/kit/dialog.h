#pragma once

#include "ui/kit/style.h"

namespace normalscope {

/// ImGui::BeginPopupModal in the middle of the window, `width` logical pixels wide where there is room for them. Where it
/// gives true, ImGui::EndPopup ends it.
bool begin_dialog(const Look& look, const char* id, float width);

}  // namespace normalscope

#pragma once

#include "ui/lecture/lecture_key.h"

#include <imgui.h>

#include <optional>

namespace normalscope {

/// What a key means in a lesson or a lecture; empty for all others.
std::optional<LectureKey> lecture_key(ImGuiKey key);
/// The same while a question waits for its answer, when letters are answers and no shortcuts.
std::optional<LectureKey> lecture_key_while_asking(ImGuiKey key);

}  // namespace normalscope

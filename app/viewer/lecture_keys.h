#pragma once

#include "ui/lecture/lecture_key.h"

#include <optional>

namespace normalscope {

/// What a key of GLFW's means in a lesson or a lecture; empty for all others.
std::optional<LectureKey> lecture_key(int key);

}  // namespace normalscope

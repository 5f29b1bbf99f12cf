#pragma once

#include "core/lessons/lesson.h"
#include "ui/kit/fonts.h"

namespace normalscope {

/// Asks for the letters of all that the lesson says, in whatever script.
void want_letters_of(const Lesson& lesson, ExtraLetters& letters, const ImFont* font);

}  // namespace normalscope

#pragma once

#include "core/image/image.h"
#include "core/lessons/lesson.h"

#include <string>

namespace normalscope {

// A lesson's step as HTML, for handouts and slides.

/// The picture itself, within the page.
std::string data_of(const Image& image);
/// `attributes` begin with a space, or are empty.
std::string picture_html(const LessonStep& step, const std::string& source, const std::string& attributes);
/// The equations, and what to look at.
std::string equations_html(const LessonStep& step);
/// The question and its choices, without the answer.
std::string question_html(const Question& question);

}  // namespace normalscope

#pragma once

#include "core/image/image.h"
#include "core/lessons/lesson.h"

#include <string>
#include <string_view>

namespace normalscope {

// A lesson's steps as HTML, for handouts and slides.

/// Of a page, up to <body>; `more` goes to the end of its head.
std::string page_head(const std::string& title, std::string_view style, const std::string& more);

/// The picture itself, within the page.
std::string data_of(const Image& image);
/// `attributes` begin with a space, or are empty.
std::string picture_html(const LessonStep& step, const std::string& source, const std::string& attributes);
/// The equations, and what to look at.
std::string equations_html(const LessonStep& step);
/// The question and its choices, without the answer.
std::string question_html(const Question& question);

}  // namespace normalscope

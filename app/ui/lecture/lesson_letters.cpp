#include "ui/lecture/lesson_letters.h"

namespace normalscope {

void want_letters_of(const Lesson& lesson, ExtraLetters& letters, const ImFont* font) {
    const auto want = [&](std::string_view words) { letters.want(words, font); };
    want(lesson.title);
    for (const LessonStep& step : lesson.steps) {
        want(step.caption);
        want(step.look_at);
        want(step.to_try);
        want(step.notes);
        for (const std::string& line : step.equations) want(line);
        for (const PointLabel& label : step.labels) want(label.text);
        if (!step.question) continue;
        want(step.question->text);
        for (const Choice& choice : step.question->choices) want(choice.text), want(choice.because);
    }
}

}  // namespace normalscope

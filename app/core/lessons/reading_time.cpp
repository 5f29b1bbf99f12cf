#include "core/lessons/reading_time.h"

#include "core/base/utf8.h"

#include <algorithm>

namespace normalscope {

namespace {

constexpr double kCharactersPerSecond = 15.0, kLeast = 3.0, kToThink = 5.0;

}  // namespace

double seconds_to_read(std::string_view words) {
    return std::max(static_cast<double>(columns(words)) / kCharactersPerSecond, kLeast);
}

double seconds_of(const LessonStep& step) {
    if (step.seconds) return *step.seconds;
    std::string words = step.caption + step.look_at;
    for (const std::string& line : step.equations) words += line;
    if (!step.question) return seconds_to_read(words);
    words += step.question->text;
    for (const Choice& choice : step.question->choices) words += choice.text;
    return seconds_to_read(words) + kToThink;
}

double seconds_of_answer(const Question& question) {
    return seconds_to_read(question.choices[right_choice(question)].because);
}

std::size_t right_choice(const Question& question) {
    return static_cast<std::size_t>(std::ranges::find(question.choices, true, &Choice::right) -
                                    question.choices.begin());
}

}  // namespace normalscope

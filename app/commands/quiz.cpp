#include "commands/commands.h"

#include "commands/files_of_run.h"
#include "commands/moodle.h"
#include "commands/step_html.h"
#include "commands/studio.h"
#include "core/base/decimal.h"
#include "core/base/error.h"
#include "core/base/html.h"
#include "core/base/math_text.h"
#include "core/frame/display_scale.h"
#include "core/lessons/exercise.h"
#include "core/lessons/open.h"
#include "platform/crash_line.h"
#include "ui/lecture/marks_of_step.h"

#include <glm/mat3x3.hpp>

namespace normalscope {

namespace {

// Two of each of the six levels.
constexpr int kExercises = 2 * (kHardestLevel + 1);
// A number of two decimals is right, and one that is off by what can be read from a picture.
constexpr double kTolerance = 0.02;
// A picture stands between words, smaller than on a screen of its own.
constexpr float kWordsInQuiz = 1.5f;

std::string number(double value) {
    const double rounded = std::round(1000.0 * value) / 1000.0;
    std::string text = with_digits(rounded == 0.0 ? 0.0 : rounded, 6);
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

std::string triple(const glm::dvec3& v) { return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")"; }

// As Moodle shows it with no style of ours: a table within two lines.
std::string matrix_html(const glm::dmat3& m) {
    std::string html =
        "<table style=\"display: inline-table; vertical-align: middle; border-left: 1px solid; border-right: 1px "
        "solid\">";
    for (int row = 0; row < 3; ++row) {
        html += "<tr>";
        for (int column = 0; column < 3; ++column)
            html += "<td style=\"padding: 0 .5em; text-align: right\">" + number(m[column][row]) + "</td>";
        html += "</tr>";
    }
    return html + "</table>";
}

class QuizWriter {
public:
    QuizWriter(const QuizCommand& command, std::size_t pictures)
        : size_(command.size), studio_({.context = command.context, .pictures = pictures}) {}

    void add(const Lesson& lesson);
    void add_exercises(std::uint64_t seed);
    std::string text() const { return quiz_.text(); }

private:
    Image picture(const Scene& scene, const StepMarks& marks = {}) {
        return studio_.capture(scene, {.size = size_, .scale = kWordsInQuiz * usual_scale(size_), .marks = marks})
            .image;
    }
    void add(const Exercise& exercise, const std::string& name);

    glm::ivec2 size_;
    Studio studio_;
    MoodleQuiz quiz_;
};

void QuizWriter::add(const Lesson& lesson) {
    const std::string title = plain_math(lesson.title);
    quiz_.category(title);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        if (!step.question) continue;
        std::string html = "<p>" + html_math(step.caption) + "</p>";
        for (const std::string& line : step.equations) html += "<p>" + html_math(line) + "</p>";
        quiz_.choices({.name = title + ", step " + std::to_string(i + 1),
                       .html = html,
                       .picture = picture(step.scene, marks_of(step)),
                       .picture_says = plain_math(step.caption),
                       .why = ""},
                      *step.question);
    }
}

void QuizWriter::add(const Exercise& exercise, const std::string& name) {
    MoodleItem item{.name = name,
                    .html = "<p>" + html_math(exercise.task) + "</p>",
                    .picture = picture(exercise.scene),
                    .picture_says = exercise.task,
                    .why = html_math(exercise.why)};
    if (exercise.question) return quiz_.choices(item, *exercise.question);
    item.html += "<div>M₃ = " + matrix_html(world_from_object(exercise.scene).normal_matrices_by_rule().naive) +
                 "</div><p>At the point " + triple(exercise.at.xyz) + " of the object, its outward unit normal is " +
                 html_math("n_obj") + " = " + triple(exercise.normal.xyz) + ". What is " + html_math("n_world") +
                 ", as a unit vector? Two decimals are enough.</p>";
    std::vector<MoodleNumber> numbers;
    for (int i = 0; i < 3; ++i)
        numbers.push_back({.right = exercise.truth.xyz[i],
                           .tolerance = kTolerance,
                           .known_wrong = exercise.naive.xyz[i],
                           .because = "That is what the naive rule gives: M₃ n, made a unit vector."});
    quiz_.numbers(item, numbers);
}

void QuizWriter::add_exercises(std::uint64_t seed) {
    const std::string set = "Exercises, set " + std::to_string(seed);
    quiz_.category(set);
    for (int i = 0; i < kExercises; ++i) add(make_exercise(seed, i), set + ", number " + std::to_string(i + 1));
}

std::string quiz_of_lessons(const QuizCommand& command) {
    const std::vector<Lesson> lessons = load_lessons(command.lesson, ", exercises:SEED");
    FilesOfRun files;
    std::size_t pictures = 0;
    for (const Lesson& lesson : lessons)
        for (const LessonStep& step : lesson.steps) {
            files.reads_scene(command.lesson, step.scene);
            pictures += step.question ? 1 : 0;
        }
    files.writes(command.output, "--output");
    if (pictures == 0) throw InputError(command.lesson, "asks no question; give a step the key question");
    QuizWriter writer(command, pictures);
    for (const Lesson& lesson : lessons) writer.add(lesson);
    return writer.text();
}

}  // namespace

int run(const QuizCommand& command) {
    const CrashLine crash_line;
    if (const auto exercises = exercises_name(command.lesson)) {
        QuizWriter writer(command, kExercises);
        writer.add_exercises(exercises->seed.value_or(0));
        write(command.output, writer.text());
    } else {
        write(command.output, quiz_of_lessons(command));
    }
    return 0;
}

}  // namespace normalscope

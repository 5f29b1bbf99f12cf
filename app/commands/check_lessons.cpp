#include "commands/commands.h"

#include "commands/manifest.h"
#include "commands/studio.h"
#include "core/base/output.h"
#include "core/base/text.h"
#include "core/frame/display_scale.h"
#include "core/lessons/open.h"
#include "core/lessons/writing.h"
#include "platform/crash_line.h"
#include "ui/lecture/marks_of_step.h"
#include "ui/offscreen_gui.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace normalscope {

namespace {

constexpr std::array kRooms{glm::ivec2(1024, 768), glm::ivec2(1280, 720), glm::ivec2(1920, 1080),
                            glm::ivec2(3840, 2160)};
constexpr double kAsSaid = 5e-4;  // as many digits as a caption has

std::string numbers_of(const LessonStep& step, Studio& studio) {
    return studio.capture(step.scene, {.size = {160, 120}, .samples = 1, .numbers = true, .marks = marks_of(step)})
        .numbers;
}

std::vector<std::string> wrong_claims(const LessonStep& step, Studio& studio) {
    if (step.numbers.empty()) return {};
    nlohmann::ordered_json expected;
    for (const auto& [path, value] : step.numbers)
        expected[path] = {{"is", value}, {"within", kAsSaid * std::max(1.0, std::abs(value))}};
    return wrong_numbers(nlohmann::ordered_json::parse(numbers_of(step, studio)), expected);
}

// Whether the words of a step leave half of the screen to the picture, presented in this room.
bool words_fit(Interface& interface, const std::shared_ptr<const Lesson>& lesson, std::size_t step, glm::ivec2 room) {
    interface.lecture().present(true);
    Scene scene;
    interface.open_lesson(lesson, scene, step);
    interface.lecture().player.arrive(scene);
    interface.prepare(Theme::Light, DisplayScale{}.of(1.0f, room, true));
    return 2 * (room.y - interface.picture(room).size.y) < room.y;
}

std::vector<std::string> rooms_too_small(const Lesson& lesson) {
    OffscreenGui gui;
    const auto shared = std::make_shared<const Lesson>(lesson);
    std::vector<std::string> lines;
    for (const glm::ivec2 room : kRooms)
        for (std::size_t i = 0; i < lesson.steps.size(); ++i)
            if (!words_fit(gui.interface, shared, i, room))
                lines.push_back("step " + std::to_string(i + 1) + ": its words leave the picture less than half of a " +
                                std::to_string(room.x) + "x" + std::to_string(room.y) + " screen; say less");
    return lines;
}

}  // namespace

int check_lessons(const LessonsCommand& command) {
    struct Checked {
        Lesson lesson;
        std::vector<std::string> wrong;
    };
    std::vector<Checked> all;
    for (const std::string& file : command.files) all.push_back({load_lesson(file), {}});
    const CrashLine crash_line;
    {
        Studio studio({.context = command.context});
        for (auto& [lesson, wrong] : all)
            for (std::size_t i = 0; i < lesson.steps.size(); ++i)
                for (const std::string& line : wrong_claims(lesson.steps[i], studio))
                    wrong.push_back("step " + std::to_string(i + 1) + ": " + line);
    }
    int code = 0;
    for (auto& [lesson, wrong] : all) {
        std::ranges::move(rooms_too_small(lesson), std::back_inserter(wrong));
        std::ranges::move(gaps(lesson), std::back_inserter(wrong));
        std::string text;
        for (const std::string& line : wrong) text += lesson.name + ", " + line + "\n";
        if (wrong.empty())
            text = lesson.name + ": " + counted(lesson.steps.size(), "step") + ", all is well\n";
        else
            code = 1;
        print(text);
    }
    return code;
}

}  // namespace normalscope

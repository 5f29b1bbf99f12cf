#include "ui/lecture/lecture.h"

#include "core/lessons/open.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace normalscope {
namespace {

TEST(Lecture, GoesOnToTheNextLessonWhenAskedTwice) {
    const std::vector<ListedLesson>& lessons = built_in_lessons();
    Scene scene;
    Lecture lecture;
    lecture.start(std::make_shared<const Lesson>(load_lesson(lessons[0].name)), scene, 0);
    const std::size_t last = lecture.player.lesson().steps.size() - 1;
    const auto press = [&](LectureKey key) { EXPECT_TRUE(lecture.press(key, scene, nullptr)); };
    const auto questions = std::ranges::count_if(lecture.player.lesson().steps,
                                                 [](const LessonStep& s) { return s.question.has_value(); });
    ASSERT_GT(questions, 0);
    for (std::ptrdiff_t i = 0; i < std::ssize(lecture.player.lesson().steps) + questions; ++i) press(LectureKey::Next);
    EXPECT_EQ(lecture.player.number(), last);
    EXPECT_FALSE(lecture.wanted_lesson());
    press(LectureKey::Previous);  // takes that back
    EXPECT_EQ(lecture.player.number(), last);
    press(LectureKey::Next);
    EXPECT_FALSE(lecture.wanted_lesson());
    press(LectureKey::Next);
    EXPECT_EQ(lecture.wanted_lesson(), lessons[1].name);
    EXPECT_FALSE(lecture.wanted_lesson());

    lecture.start(std::make_shared<const Lesson>(load_lesson(lessons.back().name)), scene, 1000);
    for (int i = 0; i < 3; ++i) press(LectureKey::Next);
    EXPECT_FALSE(lecture.wanted_lesson());
}

}  // namespace
}  // namespace normalscope

#include "core/lessons/writing.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/temporary_folder.h"
#include "core/lessons/open.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace normalscope {
namespace {

void expect_same(const Lesson& a, const Lesson& b) {
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.about, b.about);
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
        SCOPED_TRACE(a.title + ", step " + std::to_string(i + 1));
        EXPECT_EQ(a.steps[i].scene, b.steps[i].scene);
        EXPECT_EQ(a.steps[i].caption, b.steps[i].caption);
        EXPECT_EQ(a.steps[i].look_at, b.steps[i].look_at);
        EXPECT_EQ(a.steps[i].to_try, b.steps[i].to_try);
        EXPECT_EQ(a.steps[i].equations, b.steps[i].equations);
        EXPECT_EQ(a.steps[i].tab, b.steps[i].tab);
        EXPECT_EQ(a.steps[i].line, b.steps[i].line);
        EXPECT_EQ(a.steps[i].notes, b.steps[i].notes);
        EXPECT_EQ(a.steps[i].question, b.steps[i].question);
        EXPECT_EQ(a.steps[i].numbers, b.steps[i].numbers);
    }
}

class WritingTest : public testing::Test {
protected:
    std::filesystem::path file(const char* name) const { return folder_.path() / name; }
    Lesson reread(const Lesson& lesson) const {
        save_lesson(lesson, file("mine.json"));
        return load_lesson(file("mine.json").string());
    }
    TemporaryFolder folder_{std::filesystem::path(testing::TempDir()) / "writing"};
};

TEST_F(WritingTest, EveryLessonReadsBackAsItWas) {
    for (const ListedLesson& listed : built_in_lessons()) {
        const Lesson lesson = built_in_lesson(listed.name);
        expect_same(lesson, reread(lesson));
        EXPECT_EQ(lesson_text(lesson, file("mine.json")), lesson_text(reread(lesson), file("mine.json")));
    }
}

// A step says what it changes, so that another order, or one fewer, changes what the others say; not what they show.
TEST_F(WritingTest, StepsShowTheSameInAnyOrder) {
    const Lesson lesson = built_in_lesson("7-zero-and-negative-scales");
    const Lesson other = with_swapped(without_step(lesson, 1), 0, 3);
    expect_same(other, reread(other));
    EXPECT_EQ(other.steps[0].scene, lesson.steps[4].scene);
    EXPECT_EQ(without_step(new_lesson({}), 0).steps.size(), 1u);
}

TEST_F(WritingTest, AViewBecomesAStep) {
    Scene scene = load_scene("shear");
    scene.theme = Theme::Dark;  // the room's
    Lesson lesson = with_step_after(built_in_lesson("4-derivation"), 2, scene);
    lesson.steps[3].caption = "Sheared.";
    lesson.steps[3].equations = {"a", "b"};
    const Lesson read = reread(lesson);
    scene.theme = Theme::Light;
    EXPECT_EQ(read.steps[3].scene, scene);
    expect_same(lesson, read);
}

TEST_F(WritingTest, AMeshIsNamedFromTheLessonsFolder) {
    write_file(file("t.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Scene scene;
    scene.surface = MeshSurface{file("t.obj").string()};
    const Lesson lesson = new_lesson(scene);
    EXPECT_NE(lesson_text(lesson, file("mine.json")).find(R"("mesh": "t.obj")"), std::string::npos);
    const LessonStep step = reread(lesson).steps[0];
    EXPECT_TRUE(std::filesystem::equivalent(std::get<MeshSurface>(step.scene.surface).mesh, file("t.obj")));
    EXPECT_EQ(step.caption, "Step 1");
}

TEST_F(WritingTest, AQuestionIsSavedAndNothingElseOfItsStepLost) {
    const auto path = file("rich.json");
    write_file(path, R"({"normalscope": 1, "lesson": "L", "steps": [{"caption": "a", "board": "wipe", "seconds": 7,
        "highlight": "n_world", "label": {"text": "here", "at": [0, 1, 0]}, "path": {"power": [1, -1]}, "try": "Drag.",
        "notes": "Ask first.", "numbers": {"rank": 3}}]})");
    Lesson lesson = load_lesson(path.string());
    lesson.steps[0].question = Question{"Which?", {{"one", false, "No."}, {"two", true, ""}}};
    lesson.steps[0].notes = "Wait.";
    const LessonStep step = reread(lesson).steps[0];
    EXPECT_EQ(step.question, lesson.steps[0].question);
    EXPECT_EQ(step.notes, "Wait.");
    EXPECT_EQ(step.board, LessonStep::BoardIs::Wiped);
    EXPECT_EQ(step.seconds, 7.0);
    EXPECT_EQ(step.highlight, lesson.steps[0].highlight);
    EXPECT_EQ(step.labels, lesson.steps[0].labels);
    EXPECT_EQ(step.paths.size(), 1u);
    EXPECT_EQ(step.to_try, "Drag.");
    EXPECT_EQ(step.numbers, lesson.steps[0].numbers);
    lesson.steps[0].question.reset();
    lesson.steps[0].notes.clear();
    EXPECT_EQ(reread(lesson).steps[0].question, std::nullopt);
    EXPECT_EQ(reread(lesson).steps[0].notes, "");
}

// As a caption is: so that nothing that has been begun is lost.
TEST_F(WritingTest, AQuestionThatIsHalfWrittenIsSavedToo) {
    Lesson lesson = new_lesson({});
    for (const Question& begun : {Question{"Which?", {}}, Question{"", {{"one", false, ""}}},
                                  Question{"", {{"", false, "No."}, {"b", false, ""}, {"c", false, ""}}}}) {
        lesson.steps[0].question = begun;
        const std::optional<Question> read = reread(lesson).steps[0].question;
        ASSERT_TRUE(read);
        EXPECT_EQ(read->choices.size(), std::max<std::size_t>(begun.choices.size(), 2));
        EXPECT_TRUE(read->choices[0].right);
    }
}

TEST_F(WritingTest, NothingElseIsWrittenOver) {
    save_scene({}, file("scene.json"));
    const std::string before = read_file(file("scene.json"), 1 << 16);
    EXPECT_THROW(save_lesson(new_lesson({}), file("scene.json")), InputError);
    EXPECT_EQ(read_file(file("scene.json"), 1 << 16), before);
    Lesson lesson = new_lesson({});
    lesson.steps[0].caption = std::string(500, 'a');
    EXPECT_THROW(save_lesson(lesson, file("mine.json")), InputError);
    EXPECT_FALSE(std::filesystem::exists(file("mine.json")));
}

TEST(WritingLessons, WhatIsStillToBeWrittenIsSaid) {
    Lesson lesson = with_step_after(new_lesson({}), 0, {});
    lesson.steps[0].caption = "a";
    EXPECT_EQ(gaps(lesson), std::vector<std::string>{"step 2 has no words yet"});
    lesson.steps[1].caption = "b";
    EXPECT_TRUE(gaps(lesson).empty());
    lesson.steps[1].question = Question{"Where to?", {{"up", true, ""}}};
    EXPECT_EQ(gaps(lesson), std::vector<std::string>{"step 2 asks a question that needs two answers at least"});
    // Also of what a file has in its place.
    const Lesson saved = parse_lesson({lesson_text(lesson, "l.json"), "l.json", {}});
    EXPECT_EQ(gaps(saved), std::vector<std::string>{"step 2 has an answer without words"});
    lesson.steps[1].question = Question{"", {{"up", true, ""}, {"down", false, ""}}};
    EXPECT_EQ(gaps(lesson), std::vector<std::string>{"step 2 asks a question that has no words yet"});
}

}  // namespace
}  // namespace normalscope

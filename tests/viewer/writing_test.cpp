// A lesson is written in the window.

#include "viewer/writing.h"
#include "core/base/file.h"

namespace normalscope {
namespace {

TEST_F(WritingLessonsTest, ALessonIsWrittenFromViews) {
    start();
    EXPECT_FALSE(editor_is_shown());
    learn("Write a lesson");
    ASSERT_TRUE(editor_is_shown());
    EXPECT_TRUE(picture_has_room_beside());
    EXPECT_EQ(lesson().steps.size(), 1u);
    EXPECT_TRUE(is_unsaved());
    const Scene first = scene();
    EXPECT_EQ(lesson().steps[0].scene, first);

    key(ImGuiKey_R);  // another transform
    const Scene second = scene();
    ASSERT_NE(second, first);
    press_in_editor("Add this view as a step");
    EXPECT_EQ(lesson().steps.size(), 2u);
    EXPECT_EQ(step(), 1u);
    EXPECT_EQ(lesson().steps[1].scene, second);
    key(ImGuiKey_PageUp);
    EXPECT_EQ(scene(), first);

    write_into(Item("##writing/##fields") / "##Title", "Mine");
    EXPECT_EQ(lesson().title, "Mine");

    answer_dialog(ImGuiKey_S, own());
    EXPECT_FALSE(is_unsaved());
    EXPECT_EQ(named(), "mine.json");
    const Lesson read = load_lesson(own());
    EXPECT_EQ(read.title, "Mine");
    ASSERT_EQ(read.steps.size(), 2u);
    EXPECT_EQ(read.steps[0].scene, first);
    EXPECT_EQ(read.steps[1].scene, second);
    press_in_editor("Done");
    EXPECT_FALSE(editor_is_shown());
    EXPECT_FALSE(picture_has_room_beside());
    wait(3);  // its own file is no news
    EXPECT_EQ(message().find("again"), std::string::npos);
}

TEST_F(WritingLessonsTest, WhatIsOpenedIsAViewForIt) {
    start();
    learn("Write a lesson");
    open("shear");
    ASSERT_TRUE(editor_is_shown());
    EXPECT_EQ(scene().stack, load_scene("shear").stack);
    EXPECT_EQ(lesson().steps[0].scene.stack, light().stack);
    press_in_editor("Add this view as a step");
    EXPECT_EQ(lesson().steps[1].scene.stack, load_scene("shear").stack);
    open("split");
    press_in_editor("Use this view");
    EXPECT_EQ(lesson().steps.size(), 2u);
    EXPECT_EQ(lesson().steps[1].scene.view, load_scene("split").view);
    undo();
    EXPECT_EQ(lesson().steps[1].scene.stack, load_scene("shear").stack);
    open("3-when-naive-is-right");  // another lesson is another lesson
    EXPECT_FALSE(editor_is_shown());
    undo();
    EXPECT_TRUE(editor_is_shown());
    EXPECT_EQ(lesson().steps.size(), 2u);
}

TEST_F(WritingLessonsTest, StepsChangePlacesAndGoAndAllIsUndone) {
    start(light(), "5-composite-of-inverses#2");
    const Lesson before = lesson();
    learn("Change this lesson");
    EXPECT_FALSE(is_unsaved());
    press_in_editor("Later");
    EXPECT_EQ(step(), 2u);
    EXPECT_EQ(lesson().steps[2].caption, before.steps[1].caption);
    EXPECT_TRUE(is_unsaved());
    press_in_editor("Remove");
    EXPECT_EQ(lesson().steps.size(), before.steps.size() - 1);
    EXPECT_EQ(step(), 2u);
    EXPECT_EQ(scene().stack, before.steps[3].scene.stack);
    undo();
    EXPECT_EQ(lesson().steps.size(), before.steps.size());
    EXPECT_EQ(lesson().steps[2].caption, before.steps[1].caption);
    undo();
    EXPECT_EQ(lesson().steps[1].caption, before.steps[1].caption);
    EXPECT_EQ(step(), 1u);
    EXPECT_FALSE(is_unsaved());
    key(ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_Z);
    EXPECT_EQ(lesson().steps[2].caption, before.steps[1].caption);
    undo();
    undo();  // nothing is written any more
    EXPECT_FALSE(editor_is_shown());
    EXPECT_EQ(named(), "5-composite-of-inverses");
    EXPECT_TRUE(lecture().player.running());
}

TEST_F(WritingLessonsTest, NothingIsLostUnasked) {
    start();
    learn("Write a lesson");
    press_in_editor("Add this view as a step");
    key(ImGuiKey_Escape);
    ASSERT_TRUE(asked());
    key(ImGuiKey_Enter);
    EXPECT_FALSE(lecture().player.running());
    viewer().close();
    settle();
    EXPECT_TRUE(asked());
    EXPECT_FALSE(host_.closed);
    EXPECT_TRUE(lecture().player.running()) << "what is asked about is seen";
    key(ImGuiKey_S);
    type(own());
    key(ImGuiKey_Enter);
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_lesson(own()).steps.size(), 2u);
}

TEST_F(WritingLessonsTest, AnUnsavedLessonIsAskedAboutAlsoByItsCross) {
    start();
    learn("Write a lesson");
    press_in_editor("Add this view as a step");
    click(Item("##captions") / "##leave");
    ASSERT_TRUE(asked());
    key(ImGuiKey_Escape);
    EXPECT_TRUE(lecture().player.running());
    click(Item("##captions") / "##leave");
    key(ImGuiKey_Enter);
    EXPECT_FALSE(lecture().player.running());
    undo();
    EXPECT_EQ(lesson().steps.size(), 2u) << "an undo leads back to it";
    answer_dialog(ImGuiKey_S, own());
    click(Item("##captions") / "##leave");
    EXPECT_FALSE(asked());
    EXPECT_FALSE(lecture().player.running());
}

TEST_F(WritingLessonsTest, WhatAnEarlierSessionLeftIsOffered) {
    start();
    learn("Write a lesson");
    EXPECT_NE(host_.kept, "") << "nobody has saved it";
    key(ImGuiKey_R);
    press_in_editor("Add this view as a step");
    const Scene seen = scene();
    const std::string left = host_.kept;
    start(light(), "", {.scale = {}, .lessons = {}, .unsaved = parse_unsaved(left, "kept")});
    EXPECT_TRUE(asked());
    key(ImGuiKey_Enter);
    ASSERT_TRUE(lecture().player.running());
    EXPECT_EQ(lesson().steps.size(), 2u);
    EXPECT_EQ(step(), 1u);
    EXPECT_EQ(scene(), seen);
    EXPECT_TRUE(is_unsaved());
    answer_dialog(ImGuiKey_S, own());
    EXPECT_EQ(load_lesson(own()).steps.size(), 2u);
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WritingLessonsTest, SavingSaysWhatIsStillToBeWritten) {
    start();
    learn("Write a lesson");
    answer_dialog(ImGuiKey_S, own());
    EXPECT_EQ(message(), "Saved " + own() + "; step 1 has no words yet");
    write_into(Item("##writing/##fields") / "##What is said", "A cube.");
    key(ImGuiMod_Ctrl | ImGuiKey_S);
    EXPECT_EQ(message(), "Saved " + own());
}

TEST_F(WritingLessonsTest, ANewLessonIsSavedWhereItIsListed) {
    start();
    viewer().take_lessons_from({folder_.path() / "data" / "lessons"});  // which is not there yet
    learn("Write a lesson");
    answer_dialog(ImGuiKey_S, "first");
    EXPECT_EQ(named(), "first.json");
    ASSERT_TRUE(std::filesystem::exists(folder_.path() / "data" / "lessons" / "first.json")) << message();
    EXPECT_EQ(lecture().shelf.lessons.back().title, "My lesson");
}

TEST_F(WritingLessonsTest, NoSceneIsWrittenOver) {
    const auto file = write("scene.json", R"({"normalscope": 1})");
    start();
    learn("Write a lesson");
    answer_dialog(ImGuiKey_S, file.string());
    key(ImGuiKey_Enter);  // overwrite
    EXPECT_NE(message().find("holds a scene"), std::string::npos) << message();
    EXPECT_EQ(read_file(file, 1 << 16), R"({"normalscope": 1})");
    EXPECT_TRUE(is_unsaved());
}

TEST_F(WritingLessonsTest, WhatAnotherProgramWroteIsNotTakenOverOnesOwn) {
    const auto file = write("mine.json", R"({"normalscope": 1, "lesson": "L", "steps": [{"caption": "a"}]})");
    start(light(), file.string());
    learn("Change this lesson");
    write("mine.json", R"({"normalscope": 1, "lesson": "Later", "steps": [{"caption": "a"}]})");
    wait(3);
    EXPECT_EQ(lesson().title, "Later");
    EXPECT_FALSE(is_unsaved());
    press_in_editor("Add this view as a step");
    write("mine.json", R"({"normalscope": 1, "lesson": "Even later", "steps": [{"caption": "a"}]})");
    wait(1.2);
    EXPECT_NE(message().find("saving would write over it"), std::string::npos) << message();
    EXPECT_EQ(lesson().title, "Later");
    EXPECT_EQ(lesson().steps.size(), 2u);
}

}  // namespace
}  // namespace normalscope

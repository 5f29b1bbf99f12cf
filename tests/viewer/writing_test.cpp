// A lesson is written in the window.

#include "core/base/file.h"
#include "core/lessons/lesson_limits.h"
#include "viewer/hosted.h"

namespace normalscope {
namespace {

class WritingLessonsTest : public ViewerTest {
protected:
    const Lesson& lesson() const { return lecture().player.lesson(); }
    std::size_t step() const { return lecture().player.number(); }
    void learn(const char* row) {
        click(Item("##panel/##always") / "Learn");
        click(Item("##Popup") / row);
    }
    void write_into(const Item& field, std::string_view words) {
        click(field);
        keys({ImGuiMod_Ctrl | ImGuiKey_A, ImGuiKey_Delete});
        type(words);
        click(ground());
    }
    void press_in_editor(const char* button) { click(Item("##writing") / button); }
    static bool editor_is_shown() {
        const ImGuiWindow* window = ImGui::FindWindowByName("##writing");
        return window && window->Active;
    }
    bool picture_has_room_beside() {
        return viewer().frame()->rect.origin.x + viewer().frame()->rect.size.x < host_.size.x;
    }
    void undo() { key(ImGuiMod_Ctrl | ImGuiKey_Z); }
    std::string own() const { return path("mine.json"); }
};

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

TEST_F(WritingLessonsTest, AStepsQuestionAndNotesAreWritten) {
    host_.size.y = 1100;  // all fields are seen at once
    start();
    learn("Write a lesson");
    const Item editor("##writing/##fields");
    const auto question = [&] { return lesson().steps[0].question; };
    EXPECT_FALSE(question());
    click(editor / "Question and notes" / "##section");
    write_into(editor / "##ask", "Where to?");
    write_into(editor / 0 / "##answer", "up");
    write_into(editor / 1 / "##answer", "down");
    write_into(editor / 1 / "##because", "Down it is.");
    click(editor / 1 / "##right");
    write_into(editor / 2 / "##answer", "c");
    write_into(editor / "##notes", "Ask first.");
    const Question asked{"Where to?", {{"up", false, ""}, {"down", true, "Down it is."}, {"c", false, ""}}};
    EXPECT_EQ(question(), asked);
    EXPECT_EQ(lesson().steps[0].notes, "Ask first.");
    EXPECT_TRUE(lecture().asking());
    key(ImGuiKey_C);
    EXPECT_EQ(lecture().player.answer(), 2u);
    write_into(editor / 2 / "##answer", "");  // is no answer any more, also where it has been given
    ASSERT_TRUE(question());
    EXPECT_EQ(question()->choices.size(), 2u);
    EXPECT_FALSE(lecture().player.answer());
    undo();
    EXPECT_EQ(question(), asked);
    answer_dialog(ImGuiKey_S, own());
    EXPECT_EQ(load_lesson(own()).steps[0].question, asked);
    EXPECT_EQ(load_lesson(own()).steps[0].notes, "Ask first.");
    for (int i = 0; i < 7; ++i) undo();  // all of it, field by field
    EXPECT_FALSE(question());
}

TEST_F(WritingLessonsTest, NoMoreIsTypedThanALessonHolds) {
    start();
    learn("Write a lesson");
    write_into(Item("##writing/##fields") / "##Title", std::string(1000, 'a'));
    EXPECT_EQ(lesson().title, std::string(kLongestNote, 'a'));
    write_into(Item("##writing/##fields") / "##Equations, a line each", "a\nb\nc\nd");
    EXPECT_EQ(lesson().steps[0].equations, (std::vector<std::string>{"a", "b", "c"}));
}

TEST_F(WritingLessonsTest, LinesBreakWhileTheyAreTyped) {
    start();
    learn("Write a lesson");
    const Item field = Item("##writing/##fields") / "##What is said";
    const std::string sentence = "A normal is perpendicular to every tangent of the surface, wherever that is curved. ";
    std::string said;
    click(field);
    const auto shown = [] { return std::string(ImGui::GetCurrentContext()->InputTextState.TextA.Data); };
    const auto expect_in_the_field = [&] {
        EXPECT_EQ(lesson().steps[0].caption, said);
        for (std::size_t begin = 0, end; begin < shown().size(); begin = end + 1) {
            end = std::min(shown().find('\n', begin), shown().size());
            EXPECT_LE(ImGui::CalcTextSize(shown().substr(begin, end - begin).c_str()).x, 320.0f) << shown();
        }
    };
    for (const char letter : sentence + sentence) {
        type(std::string_view(&letter, 1));
        said += letter;
        expect_in_the_field();
    }
    key(ImGuiMod_Ctrl | ImGuiKey_Home);
    type("Look: ");
    said = "Look: " + said;
    expect_in_the_field();
    for (int i = 0; i < 60; ++i) undo();  // the field's own
    EXPECT_EQ(lesson().steps[0].caption, said.substr(6, said.size() - 60));
    for (int i = 0; i < 60; ++i) key(ImGuiMod_Ctrl | ImGuiKey_Y);
    expect_in_the_field();
    answer_dialog(ImGuiKey_S, own());
    EXPECT_EQ(load_lesson(own()).steps[0].caption, said);
}

TEST_F(WritingLessonsTest, EscapeLeavesAFieldAndKeepsItsText) {
    host_.size.y = 1100;
    start();
    learn("Write a lesson");
    const Item editor("##writing/##fields");
    const auto write_and_leave = [&](const Item& field, std::string_view words) {
        click(field);
        type(words);
        key(ImGuiKey_Escape);
        EXPECT_FALSE(asked()) << words;
    };
    write_and_leave(editor / "##What is said", "A cube.");
    EXPECT_EQ(lesson().steps[0].caption, "A cube.");
    write_and_leave(editor / "##Equations, a line each", "a = b");
    EXPECT_EQ(lesson().steps[0].equations, std::vector<std::string>{"a = b"});
    click(editor / "Question and notes" / "##section");
    write_and_leave(editor / 0 / "##answer", "up");
    ASSERT_TRUE(lesson().steps[0].question);
    EXPECT_EQ(lesson().steps[0].question->choices[0].text, "up");
    write_and_leave(editor / "##What is said", " It is large.");  // what was there stays, too
    EXPECT_NE(lesson().steps[0].caption.find("A cube."), std::string::npos);
    undo();  // each is a step of its own
    EXPECT_EQ(lesson().steps[0].caption, "A cube.");
    undo();
    EXPECT_FALSE(lesson().steps[0].question);
    key(ImGuiKey_Escape);
    EXPECT_TRUE(asked());
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

TEST_F(WritingLessonsTest, WhatIsBeingTypedIsKeptBeforeTheFieldIsLeft) {
    start();
    learn("Write a lesson");
    const Item editor("##writing/##fields");
    click(editor / "##What is said");
    type("A cube.");
    EXPECT_EQ(host_.kept.find("A cube."), std::string::npos);
    wait(3);
    EXPECT_NE(host_.kept.find("A cube."), std::string::npos);
    click(editor / "##What to look at");
    type("Its edges.");
    wait(3);
    EXPECT_NE(host_.kept.find("Its edges."), std::string::npos);
    const int shows = host_.shows;
    wait(5);
    EXPECT_EQ(host_.shows, shows) << "nothing is drawn for it";
}

TEST_F(WritingLessonsTest, TabGoesFromFieldToField) {
    start();  // so low a window that not all fields are seen
    learn("Write a lesson");
    const Item editor("##writing/##fields");
    click(editor / "##Equations, a line each");
    key(ImGuiKey_Tab);
    key(ImGuiKey_Space);  // unfolds the question
    click(editor / "##Title");
    const Scene before = scene();
    for (const char* words :
         {"Mine", "Said.", "Look.", "a = b", "Where to?", "up", "No.", "down", "Yes.", "", "", "Ask."}) {
        keys({ImGuiMod_Ctrl | ImGuiKey_A, ImGuiKey_Delete});
        type(words);
        key(ImGuiKey_Tab);
    }
    key(ImGuiKey_Tab);  // on, to the buttons
    EXPECT_TRUE(viewer().interface().panel_shown());
    EXPECT_EQ(scene(), before) << "nothing was taken for a shortcut";
    const LessonStep& written = lesson().steps[0];
    EXPECT_EQ(lesson().title, "Mine");
    EXPECT_EQ(written.caption, "Said.");
    EXPECT_EQ(written.look_at, "Look.");
    EXPECT_EQ(written.equations, std::vector<std::string>{"a = b"});
    const Question asked{"Where to?", {{"up", true, "No."}, {"down", false, "Yes."}}};
    EXPECT_EQ(written.question, asked);
    EXPECT_EQ(written.notes, "Ask.");
    click(ground());
    key(ImGuiKey_Tab);
    EXPECT_FALSE(viewer().interface().panel_shown());
}

TEST_F(WritingLessonsTest, EachFieldIsAStepToUndo) {
    start();
    learn("Write a lesson");
    const Item editor("##writing/##fields");
    for (const char* field : {"##Title", "##What is said", "##What to look at"}) {
        click(editor / field);  // from one to the other, without leaving them
        type("abc");
    }
    click(ground());
    EXPECT_EQ(lesson().steps[0].look_at, "abc");
    undo();
    EXPECT_EQ(lesson().steps[0].look_at, "");
    EXPECT_EQ(lesson().steps[0].caption, "abc");
    undo();
    EXPECT_EQ(lesson().steps[0].caption, "");
    EXPECT_EQ(lesson().title.find("abc"), lesson().title.size() - 3);
    undo();
    EXPECT_EQ(lesson().title, "My lesson");
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

// The fields in which a lesson is written.

#include "core/lessons/lesson_limits.h"
#include "viewer/writing.h"

namespace normalscope {
namespace {

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

}  // namespace
}  // namespace normalscope

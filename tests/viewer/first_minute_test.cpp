// What somebody meets who has never been here: the stack is played once, a sentence stands above the picture, and what a
// first look can do without is a press away.

#include "viewer/hosted.h"

#include "core/lessons/lesson.h"

namespace normalscope {
namespace {

class FirstMinuteTest : public ViewerTest {
protected:
    static Remembered nobody() { return remembered_of(""); }
    Item strip(const char* id) const { return Item("##strip") / id; }
    Item panel(const char* id) const { return Item("##panel/##always") / id; }
    bool has(const char* window) const {
        for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
            if (w->WasActive && std::string_view(w->Name).find(window) != std::string_view::npos) return true;
        return false;
    }
    void begin_to_play() {
        point(middle(strip("##play")));
        press();
        viewer().release(0, 0);
        viewer().step();
        host_.time += 0.05;
        viewer().step();
    }
};

TEST_F(FirstMinuteTest, TheVeryFirstStartPlaysTheStackOnce) {
    const Scene whole = light();
    viewer_.emplace(host_, Opened{.file = "", .scene = whole}, nobody());
    EXPECT_EQ(scene().stack_position, 0.0);
    for (double last = 0.0; scene().stack_position && host_.time < 5.0; last = scene().stack_position.value_or(1.0)) {
        host_.time += 0.05;
        viewer().step();
        EXPECT_GE(scene().stack_position.value_or(1.0), last);
    }
    EXPECT_GT(host_.time, 1.0);
    EXPECT_EQ(scene(), whole);
    EXPECT_FALSE(is_unsaved());
    key(ImGuiMod_Ctrl | ImGuiKey_Z);  // there is nothing to undo
    EXPECT_EQ(scene(), whole);
    EXPECT_FALSE(viewer().remembered().first);
    EXPECT_FALSE(remembered_of(remembered_text(viewer().remembered())).first);
}

TEST_F(FirstMinuteTest, AnyPressEndsItAtOnce) {
    viewer_.emplace(host_, Opened{.file = "", .scene = light()}, nobody());
    viewer().step();
    viewer().press(KeyPress{ImGuiKey_N});
    Scene expected = light();
    expected.rule = Rule::Naive;
    EXPECT_EQ(scene(), expected);
}

TEST_F(FirstMinuteTest, NothingPlaysWhereMotionIsUnwantedOrSomethingWasAskedFor) {
    Remembered still = nobody();
    still.motion = false;
    start(light(), "", still);
    EXPECT_EQ(scene(), light());
    start(light("shear"), "shear", nobody());
    EXPECT_EQ(scene(), light("shear"));
    start();  // somebody has been here
    EXPECT_EQ(scene(), light());
}

TEST_F(FirstMinuteTest, PlayLetsTheTransformHappenAgain) {
    start();
    const Scene before = scene();
    begin_to_play();
    EXPECT_LT(scene().stack_position.value_or(1.0), 0.5);
    settle();
    EXPECT_EQ(scene(), before);
}

TEST_F(FirstMinuteTest, UndoWhileItPlaysUndoesWhatWasDoneBefore) {
    start();
    const Scene before = scene();
    key(ImGuiKey_C);
    const Scene done = scene();
    for (const bool another : {false, true}) {
        begin_to_play();
        EXPECT_TRUE(scene().stack_position);
        if (another) viewer().press({ImGuiKey_T});
        viewer().press({ImGuiKey_Z, ImGuiMod_Ctrl});
        settle();
        EXPECT_EQ(scene(), another ? done : before);
        key(ImGuiMod_Ctrl | ImGuiKey_Y);
    }
}

TEST_F(FirstMinuteTest, WhyOpensTheLineAtStake) {
    Scene both = light();
    both.view = ViewMode::Overlay;
    start(both);
    click(strip("Why?"));  // orange is in sight: its dot product, below the lines
    EXPECT_TRUE(viewer().interface().derivation_shown());
    EXPECT_EQ(viewer().interface().marks().line, std::nullopt);
    key(ImGuiKey_Escape);
    EXPECT_FALSE(viewer().interface().derivation_shown());
    while (scene().view != ViewMode::Single) key(ImGuiKey_V);
    click(strip("Why?"));
    EXPECT_EQ(viewer().interface().marks().line->line, DerivationLine::Rule);
}

// The picture first, with its sentence; the controls are a press away.
TEST_F(FirstMinuteTest, APhoneShowsThePictureFirst) {
    host_.size = {390, 844};
    start();
    EXPECT_TRUE(has("##strip"));
    EXPECT_FALSE(has("##panel"));
    key(ImGuiKey_Tab);
    EXPECT_TRUE(has("##panel"));
    key(ImGuiKey_Tab);
    key(ImGuiKey_D);
    EXPECT_FALSE(has("##strip"));  // it would cover the row with the button that closes it
    const ImGuiWindow* const derivation = ImGui::FindWindowByName("##derivation");
    ASSERT_NE(derivation, nullptr);
    EXPECT_GE(derivation->Pos.x, 0.0f);
    key(ImGuiKey_Escape);
    EXPECT_TRUE(has("##strip"));
}

TEST_F(FirstMinuteTest, TryItStartsExercisesAndLeavingThemBringsTheSceneBack) {
    start();
    const Scene before = scene();
    click(strip("Try it"));
    EXPECT_TRUE(lecture().exercises.running());
    EXPECT_FALSE(has("##strip"));
    key(ImGuiKey_Escape);
    EXPECT_EQ(scene(), before);
    EXPECT_TRUE(has("##strip"));
}

TEST_F(FirstMinuteTest, LearnOpensALesson) {
    start();
    click(panel("Learn"));
    ASSERT_TRUE(has("##Popup"));
    for (int i = 0; i < 3; ++i) key(ImGuiKey_DownArrow);
    key(ImGuiKey_Enter);
    ASSERT_TRUE(lecture().player.running());
    const std::string name = lecture().player.lesson().name;
    EXPECT_TRUE(is_built_in_lesson(name)) << name;
}

TEST_F(FirstMinuteTest, WhatIsUnfoldedStaysSoInTheNextSession) {
    start();
    for (const char* id : {"##rules", "##tabs"}) click(panel(id));
    const Remembered later = remembered_of(remembered_text(viewer().remembered()));
    EXPECT_EQ(later.unfolded, (Unfolded{.rules = true, .tabs = true}));
    start(light(), "", later);
    click(panel("Maps"));
    EXPECT_TRUE(has("##side"));
}

TEST_F(FirstMinuteTest, AnUnfoldedThingThatIsUnknownOrNoneIsLeftOut) {
    for (const char* text :
         {R"({"unfolded": ["rules", "no such", 3]})", R"({"unfolded": "rules"})", R"({"unfolded": {}})"})
        EXPECT_EQ(remembered_of(text).unfolded.rules, std::string_view(text).find('[') != std::string_view::npos);
}

}  // namespace
}  // namespace normalscope

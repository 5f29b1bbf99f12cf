// Questions of lessons and exercises, by keyboard alone.

#include "viewer/hosted.h"

namespace normalscope {
namespace {

constexpr const char* kAsking = R"({"normalscope": 1, "lesson": "L", "steps": [
    {"caption": "a", "question": {"ask": "Where to?", "choices": [
        {"text": "up", "because": "No."}, {"text": "left", "because": "No."}, {"text": "right", "right": true, "because": "Yes."}]}},
    {"caption": "b"}]})";

class QuestionsTest : public ViewerTest {
protected:
    void ask() { start(light(), write("asking.json", kAsking).string()); }
    std::optional<std::size_t> answer() const { return lecture().player.answer(); }
    std::string score() const {
        const std::string title = lecture().exercises.state().title;
        const std::size_t begin = title.find("   ");
        return title.substr(begin, title.find(" of ") - begin);
    }
};

TEST_F(QuestionsTest, ADigitOrALetterAnswers) {
    const std::pair<ImGuiKeyChord, std::size_t> kAnswers[]{{ImGuiKey_1, 0}, {ImGuiKey_Keypad2, 1}, {ImGuiKey_3, 2},
                                                           {ImGuiKey_A, 0}, {ImGuiKey_B, 1},       {ImGuiKey_C, 2}};
    for (const auto& [pressed, choice] : kAnswers) {
        ask();
        const Scene before = scene();
        key(pressed);
        EXPECT_EQ(answer(), choice);
        EXPECT_FALSE(lecture().player.revealed());
        EXPECT_EQ(scene(), before);
    }
}

TEST_F(QuestionsTest, LettersAreNoShortcutsUntilThen) {
    ask();
    key(ImGuiKey_F5);
    const Scene before = scene();
    for (const ImGuiKey beyond : {ImGuiKey_D, ImGuiKey_E}) {
        key(beyond);
        EXPECT_EQ(scene(), before);
        EXPECT_FALSE(answer()) << "there is no such choice";
        EXPECT_FALSE(viewer().interface().derivation_shown());
    }
    key(ImGuiKey_B);
    EXPECT_EQ(answer(), 1u);
    key(ImGuiKey_C);
    EXPECT_EQ(answer(), 1u);
    EXPECT_EQ(scene().rule, Rule::Cofactor);
    key(ImGuiKey_3);  // what is wrong with the others may be looked at
    EXPECT_EQ(answer(), 2u);
    key(ImGuiKey_B);
    key(ImGuiKey_E);  // ends the black screen, and no more
    EXPECT_EQ(scene().color, before.color);
    key(ImGuiKey_E);
    EXPECT_NE(scene().color, before.color);
}

TEST_F(QuestionsTest, NextRevealsAndGoesOn) {
    for (const ImGuiKey next : {ImGuiKey_PageDown, ImGuiKey_RightArrow, ImGuiKey_Space, ImGuiKey_Enter}) {
        ask();
        key(next);
        EXPECT_EQ(lecture().player.number(), 0u);
        EXPECT_EQ(answer(), 2u);
        EXPECT_TRUE(lecture().player.revealed()) << "that is nobody's answer";
        key(next);
        EXPECT_EQ(lecture().player.number(), 1u);
        keys({ImGuiKey_PageUp, next});  // it has been answered
        EXPECT_EQ(lecture().player.number(), 1u);
    }
}

TEST_F(QuestionsTest, TheExplanationComesIntoView) {
    host_.size = {800, 430};
    start(light(), "8-bug-gallery#12");
    const ImGuiWindow* words = Item("##captions/##words").window();
    settle();
    key(ImGuiKey_A);
    EXPECT_GT(words->ScrollMax.y, 0.0f);
    EXPECT_EQ(words->Scroll.y, words->ScrollMax.y);
    key(ImGuiKey_PageUp);
    EXPECT_EQ(words->Scroll.y, 0.0f);
}

TEST_F(QuestionsTest, ARemoteControlGoesThroughExercises) {
    start(light(), "exercises:42");
    int questions = 0;
    for (int i = 0; i < 30; ++i) {
        const bool asking = lecture().exercises.asking();
        questions += asking ? 1 : 0;
        const std::string points = score();
        key(ImGuiKey_PageDown);
        if (asking) {
            EXPECT_EQ(score(), points) << "nobody has guessed it";
        }
        if (!asking) key(ImGuiKey_PageDown);  // an arrow that nobody has moved is judged the second time
        ASSERT_TRUE(lecture().exercises.answered()) << i;
        key(ImGuiKey_PageDown);
        ASSERT_FALSE(lecture().exercises.answered()) << i;
    }
    EXPECT_GT(questions, 0);
}

}  // namespace
}  // namespace normalscope

#include "ui/lecture/strip_layout.h"
#include "core/lessons/open.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace normalscope {
namespace {

class StripLayout : public testing::Test {
protected:
    StripLayout() {
        ImGui::CreateContext();
        set_style(look_, Theme::Light, 1.0f);
        ExtraLetters letters;
        look_.fonts = build_fonts(1.0f, letters, nullptr, true);
    }
    ~StripLayout() override { ImGui::DestroyContext(); }
    Look look_;
};

// It is read from as far away as the caption is.
TEST_F(StripLayout, ARoomsQuestionIsAsLargeAsTheCaption) {
    Speech speech = speech_of(load_lesson("2-gradients"), 9);
    const auto size = [&](const Speech& said) {
        return choice_box(look_, said, said.question->choices[0], 300.0f).texts.front().size;
    };
    const float small = size(speech), caption = caption_box(look_, speech, 300.0f).texts.front().size;
    EXPECT_LT(small, caption);
    speech.to_a_room = true;
    const auto in = [&](ImVec2 room) { return fitted(look_, speech, StripPlace::Side::Below, room.x, room); };
    EXPECT_EQ(size(in({1024, 1200})), caption);
    EXPECT_EQ(size(in({1024, 400})), small) << "there is no room";
}

TEST_F(StripLayout, WhatStaysOnTheBoardHasRoom) {
    const std::vector<std::string> board{"M_3 = diag(½, 2, 1)", "a = b", "c = d"};
    for (const auto side : {StripPlace::Side::Below, StripPlace::Side::Beside})
        for (const float width : {300.0f, 560.0f, 900.0f})
            for (std::size_t rows = 1; rows <= board.size(); ++rows) {
                const Speech speech{.caption = "Two.",
                                    .look_at = {},
                                    .equations = {},
                                    .question = {},
                                    .earlier = {board.begin(), board.begin() + static_cast<std::ptrdiff_t>(rows)}};
                const ImVec2 strip{width, strip_height(look_, speech, side, width)};
                EXPECT_EQ(board_rows(look_, speech, strip_rooms(look_, speech, side, strip).board_size).size(), rows)
                    << width;
            }
}

}  // namespace
}  // namespace normalscope

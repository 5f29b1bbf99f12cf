// What must be drawn again, and when nothing need be.

#include "viewer/hosted.h"

#include <cmath>

namespace normalscope {
namespace {

class RedrawTest : public ViewerTest {
protected:
    /// What has been drawn since.
    std::vector<FakeHost::Drawn> drawn_since(std::size_t before) const {
        return {host_.drawn.begin() + static_cast<std::ptrdiff_t>(before), host_.drawn.end()};
    }
};

TEST_F(RedrawTest, AnIdleViewerRests) {
    start();
    EXPECT_TRUE(std::isinf(viewer().due()));
    const std::size_t before = host_.drawn.size();
    host_.time += 100;
    viewer().step();
    EXPECT_EQ(host_.drawn.size(), before);
}

TEST_F(RedrawTest, ATooltipComesAndThenItRests) {
    start();
    point(middle(Item("##panel/##always") / "Stack"));
    EXPECT_TRUE(std::isinf(viewer().due()));
}

TEST_F(RedrawTest, ANoteGoesByItself) {
    start();
    key(ImGuiMod_Ctrl | ImGuiKey_L);
    EXPECT_NE(message(), "");
    EXPECT_GT(viewer().due(), 1.0);
    EXPECT_LT(viewer().due(), 4.0);
    wait(4.0);
    EXPECT_EQ(message(), "");
    EXPECT_TRUE(std::isinf(viewer().due()));
}

TEST_F(RedrawTest, AnEventIsFollowedByAFewFramesOfWhichOnlyWhatChangedIsDrawnAnew) {
    start();
    std::size_t before = host_.drawn.size();
    viewer().expose();
    settle();
    const auto same = drawn_since(before);
    EXPECT_EQ(same.size(), 3u);
    for (const auto& each : same) EXPECT_FALSE(each.anew);
    before = host_.drawn.size();
    key(ImGuiKey_C);
    const auto changed = drawn_since(before);
    ASSERT_FALSE(changed.empty());
    EXPECT_TRUE(changed.front().anew);
    for (std::size_t i = 1; i < changed.size(); ++i) EXPECT_FALSE(changed[i].anew);
}

TEST_F(RedrawTest, ADialogLeavesTheSamplesAsTheyAre) {
    start();
    const std::size_t before = host_.drawn.size();
    key(ImGuiMod_Ctrl | ImGuiKey_O);
    for (const auto& each : drawn_since(before)) EXPECT_FALSE(each.anew);
}

TEST_F(RedrawTest, AnotherSizeIsDrawnAnew) {
    start();
    host_.size = {1100, 720};
    viewer().expose();
    viewer().step();
    EXPECT_TRUE(host_.drawn.back().anew);
    EXPECT_EQ(viewer().frame()->rect.origin.x + viewer().frame()->rect.size.x, 1100);
}

TEST_F(RedrawTest, NoSizeIsTooSmall) {
    start();
    for (const glm::ivec2 size : {glm::ivec2(388, 300), {100, 60}, {1, 1}, {0, 0}, {1000, 720}}) {
        host_.size = size;
        viewer().expose();
        settle();
        viewer().press(KeyPress{ImGuiKey_N});
        viewer().release(KeyPress{ImGuiKey_N});
        settle();
    }
    EXPECT_EQ(scene().rule, Rule::Naive);
}

TEST_F(RedrawTest, WhatMovesIsADraftAndEndsFine) {
    start();
    point(ground());
    press();
    point(ground() + glm::dvec2(30, 0));
    EXPECT_EQ(host_.drawn.back().quality, Quality::Draft);
    release();
    EXPECT_EQ(host_.drawn.back().quality, Quality::Fine);
    EXPECT_FALSE(host_.drawn.back().rough);
}

TEST_F(RedrawTest, FontsAreUploadedOnceAndAgainForAnotherScale) {
    start();
    settle();
    const int before = host_.uploads;
    key(ImGuiKey_N);
    EXPECT_EQ(host_.uploads, before);
    key(ImGuiMod_Ctrl | ImGuiKey_Equal);
    EXPECT_GT(host_.uploads, before);
}

// The symbol's arrow in the picture is lit while one points at the symbol, and only then.
TEST_F(RedrawTest, PointingAtASymbolLightsItsArrowAtOnceAndNoLonger) {
    host_.size = {1280, 800};
    start();
    key(ImGuiKey_D);
    const auto solids = [&] { return viewer().frame()->panes.front().solids.size(); };
    const std::size_t plain = solids();
    const ImGuiWindow* lines = Item("##derivation/##lines").window();
    const ImRect area = lines->InnerRect;
    glm::dvec2 at(0.0);
    for (float y = area.Min.y; y < area.Max.y && solids() == plain; y += 7)
        for (float x = area.Min.x; x < area.Max.x && solids() == plain; x += 7) {
            viewer().pointer_to(at = glm::dvec2(x, y));
            viewer().step();
        }
    ASSERT_TRUE(viewer().interface().highlighted());
    EXPECT_NE(solids(), plain) << "in the very frame";
    EXPECT_TRUE(host_.drawn.back().anew);
    settle();
    EXPECT_NE(solids(), plain);
    viewer().pointer_to(ground());
    viewer().step();
    EXPECT_FALSE(viewer().interface().highlighted());
    EXPECT_EQ(solids(), plain);
    EXPECT_TRUE(host_.drawn.back().anew);
    point(at);
    EXPECT_NE(solids(), plain);
    viewer().pointer_left();
    settle();
    EXPECT_EQ(solids(), plain);
}

TEST_F(RedrawTest, WhatIsCopiedFromAFieldIsInTheHostsClipboard) {
    start(light("implicit-sphere"));
    keys({ImGuiMod_Ctrl | ImGuiKey_F, ImGuiMod_Ctrl | ImGuiKey_A, ImGuiMod_Ctrl | ImGuiKey_X});
    EXPECT_EQ(host_.text, std::get<FormulaSurface>(light("implicit-sphere").surface).formula);
    host_.text = "x + y";
    key(ImGuiMod_Ctrl | ImGuiKey_V);
    key(ImGuiKey_Enter);
    EXPECT_EQ(std::get<FormulaSurface>(scene().surface).formula, "x + y");
}

}  // namespace
}  // namespace normalscope

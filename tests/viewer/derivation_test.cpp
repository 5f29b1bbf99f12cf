// The derivation step by step, and what it carries in the picture.

#include "viewer/hosted.h"

#include <algorithm>

namespace normalscope {
namespace {

class DerivationTest : public ViewerTest {
protected:
    /// Step by step, at the first line.
    void begin(Remembered remembered = {}) {
        start(light(), "", std::move(remembered));
        key(ImGuiKey_D);
        click(Item("##derivation/##header") / "step by step");
    }
    std::optional<glm::vec2> label(const std::string& text) const {
        const auto& labels = viewer_->frame()->panes[0].labels;
        const auto found = std::ranges::find(labels, text, &Label::text);
        return found == labels.end() ? std::nullopt : std::optional(found->pixel);
    }
    void press_right() {
        viewer().press(KeyPress{ImGuiKey_RightArrow});
        viewer().release(KeyPress{ImGuiKey_RightArrow});
        for (int i = 0; i < 3; ++i) viewer().step();
    }
};

TEST_F(DerivationTest, EachLineHasItsArrows) {
    begin();
    const Scene before = scene();
    EXPECT_TRUE(label("n object"));
    EXPECT_TRUE(label("v object"));
    EXPECT_FALSE(label("n world"));
    key(ImGuiKey_RightArrow);
    EXPECT_TRUE(label("n world"));
    EXPECT_TRUE(label("v world"));
    EXPECT_FALSE(label("n object"));
    key(ImGuiKey_End);  // why translation drops out: none of the derivation's lines
    EXPECT_FALSE(label("n world"));
    EXPECT_FALSE(viewer().frame()->panes[0].arrows.empty());
    EXPECT_EQ(scene(), before);
}

// A remote control cannot scroll.
TEST_F(DerivationTest, AllOfItIsSeenByARoom) {
    for (const glm::ivec2 size : {glm::ivec2(1280, 720), glm::ivec2(1920, 1080), glm::ivec2(1024, 768)}) {
        host_.full = false;
        host_.size = size;
        start(light(), "4-derivation#9");
        key(ImGuiKey_F5);
        const auto expect_all_in_sight = [&] {
            const ImGuiWindow* lines = Item("##derivation/##lines").window();
            EXPECT_EQ(lines->ScrollMax.y, 0.0f) << size.x;
            EXPECT_LE(lines->ContentSize.x, lines->Size.x) << size.x;
            EXPECT_GE(viewer().frame()->rect.size.x, size.x / 3) << size.x;
        };
        expect_all_in_sight();
        click(Item("##derivation/##header") / "##numbers" / "numbers");
        expect_all_in_sight();
        click(Item("##derivation/##header") / "step by step");
        expect_all_in_sight();
    }
}

TEST_F(DerivationTest, TheArrowKeysBeginItAndGoOnWhereverOneHasClicked) {
    start();
    key(ImGuiKey_D);
    EXPECT_FALSE(label("n object"));
    key(ImGuiKey_RightArrow);
    EXPECT_TRUE(label("n object"));
    key(ImGuiKey_RightArrow);
    EXPECT_TRUE(label("n world"));
    click(ground());
    const Scene before = scene();
    key(ImGuiKey_LeftArrow);
    EXPECT_TRUE(label("n object"));
    key(ImGuiMod_Alt | ImGuiKey_RightArrow);  // that is the probe's
    EXPECT_NE(scene(), before);
    EXPECT_TRUE(label("n object"));
}

TEST_F(DerivationTest, ATangentIsCarriedWhileOneWatches) {
    begin();
    key(ImGuiKey_RightArrow);
    press_right();
    const auto from = label("M₃ v object");
    ASSERT_TRUE(from);
    EXPECT_EQ(viewer().due(), 0.0);
    host_.time += 0.45;
    viewer().step();
    const auto halfway = label("M₃ v object");
    EXPECT_EQ(viewer().frame()->quality, Quality::Draft);
    settle();
    const auto to = label("M₃ v object");
    ASSERT_TRUE(halfway && to);
    EXPECT_GT(glm::length(*to - *from), 20.0f);
    EXPECT_GT(glm::length(*halfway - *from), 5.0f);
    EXPECT_GT(glm::length(*to - *halfway), 5.0f);
    EXPECT_EQ(viewer().frame()->quality, Quality::Fine);
    EXPECT_GT(viewer().due(), 0.1);
    key(ImGuiKey_RightArrow);  // the next line leaves it where it is
    EXPECT_EQ(label("M₃ v object"), to);
}

TEST_F(DerivationTest, ItIsThereAtOnceWhereMotionIsUnwanted) {
    begin({.motion = false});
    key(ImGuiKey_RightArrow);
    press_right();
    const auto at_once = label("M₃ v object");
    wait(2.0);
    EXPECT_EQ(label("M₃ v object"), at_once);
}

}  // namespace
}  // namespace normalscope

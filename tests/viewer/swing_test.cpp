// The slider between the two rules, and how a rule's arrows swing to their place.

#include "viewer/hosted.h"

namespace normalscope {
namespace {

class SwingTest : public ViewerTest {
protected:
    Item slider() const { return Item("##panel/##always") / "##power"; }
    /// Along the slider, from 0, M n, to 1, (M⁻¹)ᵀ n.
    glm::dvec2 on_slider(double share) {
        const glm::dvec2 at = middle(slider());
        return at + glm::dvec2((share - 0.5) * 340.0, 0.0);
    }
    /// How far the arrow at the probe is off, as drawn last.
    double off(Rule rule) const {
        const ProbeInWorld& probe = *viewer_->frame()->probe;
        return *angle_degrees(probe.normals[rule]->xyz, probe.truth->xyz);
    }
    void step(double seconds) {
        host_.time += seconds;
        viewer().step();
    }
};

TEST_F(SwingTest, TheSliderBendsTheArrowsAndTheLightUntilTheyAreRight) {
    start();
    const Scene before = scene();
    const double naive = off(Rule::Naive);
    EXPECT_GT(naive, 50.0);
    point(on_slider(0.15));
    press();
    double last = naive + 1e-9;
    for (const double share : {0.2, 0.35, 0.5, 0.75, 0.9}) {
        point(on_slider(share));
        EXPECT_EQ(scene().rule, Rule::Naive);
        EXPECT_LT(off(Rule::Naive), last);
        EXPECT_GT(off(Rule::Naive), 0.0);
        EXPECT_LT(off(Rule::InverseTranspose), 1e-9);
        last = off(Rule::Naive);
        EXPECT_EQ(scene().power == 0.0, share == 0.5);  // where it catches
    }
    point(on_slider(1.05));
    release();
    EXPECT_EQ(scene().power, -1.0);
    EXPECT_LT(off(Rule::Naive), 1e-9);
    expect_undo({before, scene()});
}

TEST_F(SwingTest, WithoutAnInverseTheSliderEndsAtTheRotation) {
    Scene flat = light();
    flat.stack = {Scale{{1, 0, 1}}};
    start(flat);
    drag({on_slider(0.1), on_slider(0.6), on_slider(1.0)});
    EXPECT_EQ(scene().power, 0.0);
}

TEST_F(SwingTest, ARulesArrowsComeFromTheOthersPlace) {
    Scene overlay = light();
    overlay.view = ViewMode::Overlay;
    start(overlay);
    const double naive = off(Rule::Naive);
    for (const auto& [letter, moving, still] : {std::tuple{ImGuiKey_N, Rule::Naive, Rule::InverseTranspose},
                                                std::tuple{ImGuiKey_I, Rule::InverseTranspose, Rule::Naive}}) {
        viewer().press(KeyPress{letter});
        viewer().release(KeyPress{letter});
        EXPECT_EQ(scene().rule, moving);  // the scene is there at once
        EXPECT_EQ(scene().power, 1.0);
        step(0.0);
        const double from = moving == Rule::Naive ? 0.0 : naive, to = naive - from;
        EXPECT_NEAR(off(moving), from, 1e-6);
        step(Swing::kSeconds / 2);
        EXPECT_GT(off(moving), 5.0);
        EXPECT_LT(off(moving), naive - 5.0);
        EXPECT_NEAR(off(still), still == Rule::Naive ? naive : 0.0, 1e-9);
        EXPECT_EQ(viewer().frame()->quality, Quality::Draft);
        step(Swing::kSeconds);
        EXPECT_NEAR(off(moving), to, 1e-9);
        settle();
        EXPECT_NEAR(off(moving), to, 1e-9);
        EXPECT_EQ(viewer().frame()->quality, Quality::Fine);
        EXPECT_FALSE(host_.drawn.back().anew && host_.drawn.back().rough);
    }
    EXPECT_GT(viewer().due(), 0.1);  // and it rests
}

TEST_F(SwingTest, ItGoesOnFromWhereTheSliderLeftTheArrows) {
    start();
    drag({on_slider(0.1), on_slider(0.3), on_slider(0.5)});
    const Scene before = scene();
    const double bent = off(Rule::Naive);
    viewer().press(KeyPress{ImGuiKey_N});
    viewer().release(KeyPress{ImGuiKey_N});
    step(0.0);
    EXPECT_NEAR(off(Rule::Naive), bent, 1e-6);
    settle();
    EXPECT_EQ(scene().power, 1.0);
    expect_undo({before, scene()});
}

TEST_F(SwingTest, NothingMovesWhereMotionIsUnwanted) {
    start(light(), "", {.motion = false});
    const double naive = off(Rule::Naive);
    viewer().press(KeyPress{ImGuiKey_N});
    viewer().release(KeyPress{ImGuiKey_N});
    step(0.0);
    EXPECT_NEAR(off(Rule::Naive), naive, 1e-9);
    EXPECT_FALSE(viewer().remembered().motion);
    open("1-normal-as-a-point");
    key(ImGuiKey_PageDown);
    EXPECT_FALSE(lecture().player.moving());
}

TEST_F(SwingTest, WhatCannotSwingIsThereAtOnce) {
    Scene mistaken = light();
    mistaken.mistake = Mistake::NotTransposed;
    Scene flat = light();
    flat.stack = {Scale{{1, 0, 1}}};
    for (const Scene& scene : {mistaken, flat}) EXPECT_FALSE(Swing::to(Rule::Naive, scene, 0.0));
    EXPECT_FALSE(Swing::to(Rule::Cofactor, light(), 0.0));
}

}  // namespace
}  // namespace normalscope

// The sliders and buttons of the panel, formulas and tabs, as a hand moves them.

#include "viewer/hosted.h"

namespace normalscope {
namespace {

class PanelTest : public ViewerTest {
protected:
    Item bar(const char* id) const { return Item("##panel/##rest") / 0 / id; }
    Item rule(const char* label) const { return Item("##panel/##always") / label / "##rule"; }
    glm::dvec3 factors() const { return std::get<Scale>(scene().stack.at(0)).factors; }
    void slide(const char* id, double by) {
        const glm::dvec2 at = middle(bar(id));
        drag({at, at + glm::dvec2(by / 2, 0), at + glm::dvec2(by, 0)});
    }
    Item tab(const char* label) const { return Item("##panel/##always") / label; }
    void type_formula(std::string_view text) {
        keys({ImGuiMod_Ctrl | ImGuiKey_F, ImGuiMod_Ctrl | ImGuiKey_A});
        type(text);
    }
    std::string formula() const { return std::get<FormulaSurface>(scene().surface).formula; }
};

TEST_F(PanelTest, ASliderMovesOneFactor) {
    start();
    const Scene before = scene();
    slide("##y", -20);
    EXPECT_LT(factors().y, 1.9);
    EXPECT_GT(factors().y, 1.0);
    EXPECT_EQ(factors().x, 0.5);
    EXPECT_EQ(factors().z, 1.0);
    expect_undo({before, scene()});
}

TEST_F(PanelTest, ASliderThroughZero) {
    start();
    const Scene before = scene();
    slide("##x", -50);
    EXPECT_LT(factors().x, 0.0);
    EXPECT_GT(factors().x, -2.0);
    expect_undo({before, scene()});
}

// Whatever there is to be said of a reflection or of a flat object.
TEST_F(PanelTest, TheSlidersStayWhereTheyAre) {
    start();
    const glm::dvec2 x = middle(bar("##x")), y = middle(bar("##y")), z = middle(bar("##z"));
    for (const auto& [id, by] : std::vector<std::pair<const char*, double>>{{"##x", -50}, {"##z", -40}, {"##y", -20}}) {
        slide(id, by);
        EXPECT_EQ(middle(bar("##x")), x);
        EXPECT_EQ(middle(bar("##y")), y);
        EXPECT_EQ(middle(bar("##z")), z);
    }
}

TEST_F(PanelTest, ASliderCatchesAtOneAndItsLetterSetsItBack) {
    start();
    const Scene before = scene();
    slide("##z", 3);
    EXPECT_EQ(scene(), before);
    slide("##z", 20);
    EXPECT_GT(factors().z, 1.2);
    slide("##x", 19);  // from 0.5 to nearly 1
    const glm::dvec2 y = middle(bar("##y"));
    slide("##y", -25);
    EXPECT_NE(factors().y, 2.0);
    click(glm::dvec2(36.0, y.y));
    EXPECT_EQ(factors().y, 1.0);
}

TEST_F(PanelTest, NumbersAreTypedAfterAClickWhichAloneChangesNothing) {
    start();
    const Scene before = scene();
    click(bar("##z"));
    EXPECT_EQ(scene(), before);
    key(ImGuiKey_Escape);
    struct Row {
        const char* text;
        double value;
    };
    for (const auto& [text, value] : {Row{"-1.5e0", -1.5}, Row{"nan", -1.5}, Row{"0", 0}, Row{"1/4", 0.25}}) {
        click(bar("##z"));
        type(text);
        for (const ImGuiKey letter : {ImGuiKey_E, ImGuiKey_N}) viewer().press(KeyPress{letter});  // no shortcuts here
        key(ImGuiKey_Enter);
        Scene expected = before;
        std::get<Scale>(expected.stack.at(0)).factors.z = value;
        EXPECT_EQ(scene(), expected) << text;
    }
}

TEST_F(PanelTest, LockedFactorsKeepTheirProportions) {
    start();
    click(bar("##lock"));
    slide("##y", -20);
    EXPECT_LT(factors().y, 1.9);
    EXPECT_NEAR(factors().x, factors().y / 4, 1e-9);
    EXPECT_NEAR(factors().z, factors().y / 2, 1e-9);
}

TEST_F(PanelTest, ButtonsChooseTheRule) {
    start();
    Scene before = scene();
    click(Item("##panel/##always") / "##rules");  // the cofactor is behind it
    for (const auto& [label, chosen] : std::vector<std::pair<const char*, Rule>>{
             {"naive", Rule::Naive}, {"cofactor", Rule::Cofactor}, {"inverse transpose", Rule::InverseTranspose}}) {
        click(rule(label));
        EXPECT_EQ(scene().rule, chosen);
    }
    for (int i = 0; i < 3; ++i) key(ImGuiMod_Ctrl | ImGuiKey_Z);
    EXPECT_EQ(scene(), before);
}

TEST_F(PanelTest, AFormulaIsTypedAndIsOneStepToUndo) {
    start(light("implicit-sphere"));
    const Scene before = scene();
    type_formula("x^2+y^2+2z^2-a");
    key(ImGuiKey_Enter);
    EXPECT_EQ(formula(), "x^2+y^2+2z^2-a");
    expect_undo({before, scene()});
}

TEST_F(PanelTest, WhatATypedFormulaMeansIsInThePicture) {
    start(light("implicit-sphere"));
    const Scene before = scene();
    type_formula("x^2+y^2+z^2-1.1");
    key(ImGuiKey_Enter);
    EXPECT_EQ(scene().camera, before.camera);
    const Scene in_it = scene();
    type_formula("x^2+y^2+z^2-0.0001");
    key(ImGuiKey_Enter);
    EXPECT_GT(scene().camera.magnification(), 3.0 * before.camera.magnification());
    expect_undo({before, in_it, scene()});
}

// All before one picture, and Ctrl let go of first, as fingers do.
TEST_F(PanelTest, AQuickCtrlASelectsAll) {
    start(light("implicit-sphere"));
    type_formula("x^2+y^2+z^2-0.5");
    viewer().press(KeyPress{ImGuiKey_LeftCtrl, 0});
    viewer().press(KeyPress{ImGuiKey_A, ImGuiMod_Ctrl});
    viewer().release(KeyPress{ImGuiKey_LeftCtrl, ImGuiMod_Ctrl});
    viewer().release(KeyPress{ImGuiKey_A, 0});
    type("x+y");
    EXPECT_EQ(formula(), "x+y");
}

TEST_F(PanelTest, TheLastGoodFormulaStays) {
    start(light("implicit-sphere"));
    const Scene before = scene();
    for (const char* text : {"x^", "foo(x)+y", "x^2+y^2+", "1e400*x"}) {
        type_formula(text);
        key(ImGuiKey_Enter);
        EXPECT_EQ(scene(), before) << text;  // its beginning can be read, and nobody means that
    }
    type_formula("x+y+");
    wait(1.5);
    EXPECT_EQ(scene(), before);
    type("z");
    key(ImGuiKey_Enter);
    EXPECT_EQ(formula(), "x+y+z");
    expect_undo({before, scene()});
}

TEST_F(PanelTest, APauseMakesAStep) {
    start(light("implicit-sphere"));
    const Scene before = scene();
    type_formula("x+y");
    wait(1.5);
    type("+z");
    key(ImGuiKey_Enter);
    EXPECT_EQ(formula(), "x+y+z");
    key(ImGuiMod_Ctrl | ImGuiKey_Z);
    EXPECT_EQ(formula(), "x+y");
    key(ImGuiMod_Ctrl | ImGuiKey_Z);
    EXPECT_EQ(scene(), before);
}

TEST_F(PanelTest, AShapeGivesWayToAFormula) {
    start();
    const Scene before = scene();
    type_formula("y - x z");
    key(ImGuiKey_Enter);
    EXPECT_EQ(formula(), "y - x z");
    Scene expected = before;
    expected.surface = scene().surface;
    expected.about = "";  // it told of the shape
    expected.camera = scene().camera;
    EXPECT_LT(scene().camera.magnification(), before.camera.magnification());  // it is twice as large
    EXPECT_EQ(scene(), expected);
}

// Its surface takes seconds. Meanwhile the one before is shown, and Esc goes back to it; what was typed is a redo away.
TEST_F(PanelTest, AFormulaThatTakesLongCanBeGivenUp) {
    start(light("implicit-sphere"));
    type_formula("x+y");
    wait(2.0);
    const auto shown = [&] { return viewer().frame()->surface->implicit->source().formula; };
    std::string slow = "x^2+y^2+z^2-1";
    for (int i = 0; i < 30; ++i) slow += "+0.01tan(" + std::to_string(i) + "x/9+y)";
    const auto begin = [&] {
        for (int i = 0; i < 1000 && !viewer().making_surface(); ++i) host_.time += 0.02, viewer().step();
        ASSERT_TRUE(viewer().making_surface());
        host_.time += 1.0;
        viewer().step();
        EXPECT_EQ(message(), "Computing the surface \u2026  Esc cancels");
        EXPECT_EQ(shown(), "x+y");
    };
    keys({ImGuiMod_Ctrl | ImGuiKey_F, ImGuiMod_Ctrl | ImGuiKey_A});
    for (const char letter : slow) viewer().type(static_cast<char32_t>(letter));
    begin();
    key(ImGuiKey_Escape);
    EXPECT_FALSE(viewer().making_surface());
    EXPECT_EQ(formula(), "x+y");
    EXPECT_EQ(shown(), "x+y");
    viewer().press(KeyPress{ImGuiKey_Y, ImGuiMod_Ctrl});
    EXPECT_EQ(formula(), slow);
    begin();
    settle();
    EXPECT_EQ(shown(), slow);
    EXPECT_EQ(message(), "");
}

// Escape leads the keyboard from what is within the panel to the panel, and from there away.
TEST_F(PanelTest, AFormulaCanBeTypedAnewAfterEscape) {
    start(light("implicit-sphere"));
    for (const char* text : {"x+y+z", "x^2+foo(y"})
        for (int escapes = 0; escapes < 4; ++escapes) {
            type_formula(text);
            key(ImGuiKey_Enter);
            for (int i = 0; i < escapes; ++i) key(ImGuiKey_Escape);
            type_formula("x+y");
            EXPECT_EQ(formula(), "x+y") << text << ", " << escapes;
        }
}

TEST_F(PanelTest, CtrlAndALetterLeaveAField) {
    start(light("implicit-sphere"));
    type_formula("x+y");
    key(ImGuiMod_Ctrl | ImGuiKey_S);
    EXPECT_TRUE(viewer().interface().dialog_shown());
    EXPECT_EQ(formula(), "x+y");
}

TEST_F(PanelTest, WhoChangesAnEntrySeesItAct) {
    Scene nothing_acts = light();
    nothing_acts.stack_position = 0.0;
    start(nothing_acts);
    slide("##y", -20);
    EXPECT_EQ(scene().stack_position, std::nullopt);
    EXPECT_LT(factors().y, 1.9);
}

TEST_F(PanelTest, CtrlFSelectsTheFormulaAlsoWhereItHasTheKeyboard) {
    start(light("implicit-sphere"));
    type_formula("x+y");
    key(ImGuiKey_Enter);
    key(ImGuiMod_Ctrl | ImGuiKey_F);
    type("y+z");
    EXPECT_EQ(formula(), "y+z");
}

TEST_F(PanelTest, ScrubbingTheStackMovesTheObject) {
    Scene two = light("shear");
    two.stack = {Scale{{1, 2, 1}}, Rotate{{0, 0, 1}, 40}};
    host_.size = {1280, 800};
    start(two);
    click(tab("Stack"));
    const Item slider = Item("##side/##tab") / "##position";
    const glm::dvec2 at = middle(slider);
    drag({at, at - glm::dvec2(20, 0), at - glm::dvec2(60, 0)});
    ASSERT_TRUE(scene().stack_position);
    EXPECT_LT(*scene().stack_position, 2.0);
    Scene whole = scene();
    whole.stack_position.reset();
    EXPECT_EQ(whole, two);
    expect_undo({two, scene()});
}

TEST_F(PanelTest, ArrowKeysStepTheRayWhoseStepperStandsStill) {
    Scene ray = light();
    ray.ray = AimedRay{.from = Point<World>{{-1.2, 1.2, 0.6}}, .toward = Point<World>{{0, 0.2, 0.4}}, .step = 0};
    host_.size = {1280, 600};
    start(ray);
    click(tab("##tabs"));
    click(tab("Ray"));
    const glm::dvec2 at = middle(Item("##side/##head") / "##next");
    for (int i = 1; i <= AimedRay::kLastStep + 1; ++i) {
        key(ImGuiKey_RightArrow);
        EXPECT_EQ(scene().ray->step, std::min(i, AimedRay::kLastStep));
        EXPECT_EQ(middle(Item("##side/##head") / "##next"), at);
    }
    key(ImGuiKey_LeftArrow);
    EXPECT_EQ(scene().ray->step, AimedRay::kLastStep - 1);
    click(Item("##side/##head") / "##previous");
    EXPECT_EQ(scene().ray->step, AimedRay::kLastStep - 2);
}

TEST_F(PanelTest, PlayingEndsWithTheWholeStackAndIsNothingToUndo) {
    Scene two = light("shear");
    two.stack = {Scale{{1, 2, 1}}, Rotate{{0, 0, 1}, 40}};
    host_.size = {1280, 800};
    start(two);
    click(tab("Stack"));
    click(Item("##side/##tab") / "##play");
    EXPECT_EQ(scene(), two);  // played to its end
    key(ImGuiMod_Ctrl | ImGuiKey_Z);
    EXPECT_EQ(scene(), two);
}

TEST_F(PanelTest, AFingerScrollsWhateverDoes) {
    host_.size = {1000, 420};
    start();
    const Item slider = bar("##y");
    ImGuiWindow& rest = *slider.window();
    point(middle(slider));
    ASSERT_TRUE(viewer().grab_to_scroll());
    const float before = rest.Scroll.y;
    viewer().pointer_left();
    for (const double pixels : {-20.0, -15.0}) viewer().scroll_grabbed(pixels);  // before one picture
    settle();
    EXPECT_EQ(rest.Scroll.y, before + 35);
    viewer().scroll_grabbed(1e4);
    settle();
    EXPECT_EQ(rest.Scroll.y, 0);
    point(ground());
    EXPECT_FALSE(viewer().grab_to_scroll());
    const ImVec2 bar_middle = ImGui::GetWindowScrollbarRect(&rest, ImGuiAxis_Y).GetCenter();
    point({bar_middle.x, bar_middle.y});
    EXPECT_FALSE(viewer().grab_to_scroll()) << "the scroll bar is dragged";
}

TEST_F(PanelTest, ASliderFollowsTheFingerAndAButtonDoesNot) {
    start();
    point(middle(bar("##y")));
    EXPECT_FALSE(viewer().holds_what_follows());
    press();
    EXPECT_TRUE(viewer().holds_what_follows());
    release();
    point(middle(rule("naive")));
    press();
    EXPECT_FALSE(viewer().holds_what_follows());
    viewer().pointer_left();
    release();
    EXPECT_EQ(scene().rule, Rule::InverseTranspose) << "let go elsewhere";
}

}  // namespace
}  // namespace normalscope

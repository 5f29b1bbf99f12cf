#include "ui/typeset/formula_box.h"
#include "core/formula/formula.h"
#include "core/formula/parse.h"
#include "ui/panel/formula_section.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace normalscope {
namespace {

class FormulaBoxTest : public testing::Test {
protected:
    FormulaBoxTest() {
        ImGui::CreateContext();
        set_style(look_, Theme::Light, 1.0f);
        ExtraLetters letters;
        look_.fonts = build_fonts(1.0f, letters);
        style_ = math_style(look_);
    }
    ~FormulaBoxTest() override { ImGui::DestroyContext(); }

    FormulaBox set(std::string_view text, float width = 1e6f, std::size_t lines = 100) const {
        formulas::Graph graph;
        const formulas::Id id = formulas::parse(graph, text);
        return formula_box(style_, formulas::pieces(graph, id, 1500), width, lines);
    }
    static std::string signs(const FormulaBox& f) {
        std::string text;
        for (const MathBox::Text& t : f.box.texts) text += t.text;
        return text;
    }

    Look look_;
    MathStyle style_{};
};

TEST_F(FormulaBoxTest, SetsEverySign) {
    EXPECT_EQ(signs(set("x^2 + y^2 - 1")), "x2+y2−1");
    EXPECT_EQ(signs(set("sin(2x) cos(pi y)")), "sin2xcosπy");
    const FormulaBox fraction = set("x/(y+1)");
    EXPECT_EQ(signs(fraction), "xy+1");
    EXPECT_LT(fraction.box.texts[0].at.y, fraction.box.texts[1].at.y);
    EXPECT_GT(set("sqrt(x)").box.strokes.size(), 0u);
    EXPECT_EQ(signs(set("x^(y^z)")), "xyz");
}

TEST_F(FormulaBoxTest, ExponentsAreSmallerAndHigher) {
    const FormulaBox square = set("x^2");
    ASSERT_EQ(square.box.texts.size(), 2u);
    EXPECT_LT(square.box.texts[1].size, square.box.texts[0].size);
    EXPECT_LT(square.box.texts[1].at.y + square.box.texts[1].size, square.box.texts[0].at.y + square.box.texts[0].size);
}

TEST_F(FormulaBoxTest, BreaksBeforeTermsAndLosesNothing) {
    const std::string text =
        "189x^2y+189x^2z-81x^3+189x y^2-54x y z+189x z^2-81y^3+189y^2z+189y z^2-81z^3+9x^2-126x y+1";
    const FormulaBox one = set(text), broken = set(text, 300.0f);
    EXPECT_EQ(one.lines, 1u);
    EXPECT_GT(broken.lines, 2u);
    EXPECT_TRUE(broken.whole);
    EXPECT_LE(broken.box.width, 300.0f);
    EXPECT_EQ(signs(one), signs(broken));
    const FormulaBox cut = set(text, 300.0f, 2);
    EXPECT_FALSE(cut.whole);
    EXPECT_EQ(cut.lines, 2u);
}

TEST_F(FormulaBoxTest, BreaksFractionsThatAreWiderThanALine) {
    const std::string text = "x + (x+2)(y+3)(z+4)(x+y+5)(y+z+6)(z+x+7)/(x+1)";
    const FormulaBox one = set(text), broken = set(text, 220.0f);
    EXPECT_TRUE(broken.whole);
    EXPECT_LE(broken.box.width, 220.0f);
    EXPECT_EQ(signs(one).size() + 1, signs(broken).size());  // the stroke has become a slash
}

TEST_F(FormulaBoxTest, SetsCasesThatAreWiderThanALineBelowEachOther) {
    const formulas::Formula f = formulas::read("max(abs(x),abs(y),abs(z))=1");
    const auto pieces = formulas::pieces(f.graph, f.expressions()[1], 1500);
    const FormulaBox one = formula_box(style_, pieces, 1e6f, 6), narrow = formula_box(style_, pieces, 280.0f, 6);
    EXPECT_TRUE(narrow.whole);
    EXPECT_LE(narrow.box.width, 280.0f);
    EXPECT_GT(narrow.box.height(), one.box.height());
    EXPECT_EQ(signs(one), signs(narrow));
}

TEST_F(FormulaBoxTest, BreaksWithinABracketThatIsWiderThanALine) {
    const std::string text = "min(x^2 + y^2 + z^2 - 1, (x + y)(y + z)(z + x) - 2, |x - y| - 0.3) + 1";
    const FormulaBox one = set(text), broken = set(text, 240.0f);
    EXPECT_FALSE(one.broken_inside);
    EXPECT_TRUE(broken.broken_inside);
    EXPECT_TRUE(broken.whole);
    EXPECT_LE(broken.box.width, 240.0f);
    EXPECT_EQ(signs(one), signs(broken));
}

TEST_F(FormulaBoxTest, TakesWhateverCanBeRead) {
    std::string deep = "x", tower = "x";
    for (int i = 0; i < 400; ++i) deep = "sin(" + deep + ")";
    for (int i = 0; i < 60; ++i) tower = "x^(" + tower + ")";
    for (const std::string& text :
         {deep, tower, std::string("1e200x"), std::string("|x|^a+min(x,y)"), std::string("0"), std::string("-x")}) {
        const formulas::Formula f = formulas::read(text);
        for (const formulas::Id id : f.expressions()) {
            const FormulaBox box = formula_box(style_, formulas::pieces(f.graph, id, 1500), 280.0f, 4);
            EXPECT_LE(box.lines, 4u);
            EXPECT_TRUE(std::isfinite(box.box.width) && std::isfinite(box.box.height()));
        }
    }
}

TEST(FormulaDraft, KeepsTheLastGoodFormulaWhileOneTypes) {
    FormulaSurface scene{.formula = "a x + y"};
    scene.parameters[0] = 0.5;
    FormulaDraft draft;
    EXPECT_TRUE(draft.follow(scene));
    EXPECT_FALSE(draft.follow(scene));
    draft.text = "a x + ";
    draft.typed(scene);
    ASSERT_TRUE(draft.mistake());
    EXPECT_EQ(draft.mistake()->column, 7u);
    EXPECT_NE(draft.mistake()->message.find("expected"), std::string::npos);
    EXPECT_EQ(scene.formula, "a x + y");
    // A letter that is gone counts for nothing; where it comes back, so does its value.
    draft.text = "x + y";
    draft.typed(scene);
    EXPECT_FALSE(draft.mistake());
    EXPECT_EQ(scene.parameters, formulas::kAllOne);
    draft.text = "a x + y + b";
    draft.typed(scene);
    EXPECT_EQ(scene.parameters[0], 0.5);
    // What others do to the scene shows in the text.
    scene = FormulaSurface{.formula = "z"};
    draft.text = "x +";
    draft.typed(scene);
    EXPECT_FALSE(draft.follow(FormulaSurface{.formula = "a x + y + b"}));
    EXPECT_TRUE(draft.follow(scene));
    EXPECT_EQ(draft.text, "z");
    EXPECT_FALSE(draft.mistake());
}

}  // namespace
}  // namespace normalscope

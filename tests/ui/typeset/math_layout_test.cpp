#include "ui/typeset/math_layout.h"
#include "core/explain/derivation.h"
#include "ui/tabs/derivation_passages.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <random>
#include <set>

namespace normalscope {
namespace {

class MathLayout : public testing::Test {
protected:
    MathLayout() {
        ImGui::CreateContext();
        set_style(look_, Theme::Light, 1.0f);
        ExtraLetters letters;
        look_.fonts = build_fonts(1.0f, letters);
        style_ = math_style(look_);
    }
    ~MathLayout() override { ImGui::DestroyContext(); }

    static Derivation derivation_of(const glm::dmat3& m3) {
        const Probe probe{.point = {{0.1, 0.7, 0.7}},
                          .normal = {{0.48, 0.6, 0.64}},
                          .tangents = {{{{0.8, 0.0, -0.6}}, {{-0.36, 0.8, -0.48}}}}};
        return derivation(Transform<World, Object>(glm::dmat4(m3)), 1, probe);
    }
    static constexpr float kWidth = 374.0f;

    Look look_;
    MathStyle style_{};
};

const glm::dmat3 kRunningExample{{0.5, 0, 0}, {0, 2, 0}, {0, 0, 1}};
const AsNumber kNames = [](Place, const Expression&) { return false; };
const AsNumber kNumbers = [](Place, const Expression& part) { return part.kind == Expression::Kind::Symbol; };

std::vector<AlignedEquation> equations(const Look& look, const Derivation& d, const AsNumber& as_number, float width) {
    return fitted(
        look, d.steps.size(),
        [&](const MathStyle& style, std::size_t i) {
            return Equation{expression_box(style, d.steps[i].left(), as_number),
                            expression_box(style, d.steps[i].right(), as_number)};
        },
        width);
}

float sign_drawn_at(const MathBox& box) {
    for (const MathBox::Text& text : box.texts)
        if (text.text == "=") return text.at.x;
    return -1.0f;
}

TEST_F(MathLayout, EqualsSignsStandAboveEachOther) {
    const auto lines = equations(look_, derivation_of(kRunningExample), kNames, kWidth);
    ASSERT_EQ(lines.size(), 10u);
    for (const AlignedEquation& line : lines) {
        EXPECT_EQ(line.sign, lines.front().sign);
        EXPECT_EQ(sign_drawn_at(line.box), line.sign);
    }
}

TEST_F(MathLayout, NumbersBreakTheColumnOnlyWhereTheyMust) {
    const auto lines = equations(look_, derivation_of(kRunningExample), kNumbers, kWidth);
    std::set<float> signs;
    for (const AlignedEquation& line : lines) signs.insert(line.sign);
    EXPECT_EQ(lines[0].sign, lines[6].sign);  // all that end in "= 0"
    EXPECT_LT(signs.size(), 5u);
}

TEST_F(MathLayout, FitsWhateverTheNumbers) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> entry(-2.0, 2.0), exponent(-9.0, 9.0);
    for (int i = 0; i < 100; ++i) {
        glm::dmat3 m;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) m[c][r] = entry(random) * (i % 2 ? std::pow(10.0, exponent(random)) : 1.0);
        for (const AlignedEquation& line : equations(look_, derivation_of(m), kNumbers, kWidth))
            EXPECT_LE(line.box.width, kWidth);
    }
}

TEST_F(MathLayout, NothingMovesAsNumbersChange) {
    const auto box = [&](double x, double y) { return value_box(style_, value_of(glm::dvec3(x, y, 0.0)), Ink::Plain); };
    const MathBox first = box(0.125, 1.0);
    for (const auto& [x, y] : {std::pair(-0.125, 9.9), {-9.25, 0.001}, {12.5, -3.0}, {-999.9, 17.0}, {0.0, -9000.4}}) {
        const MathBox other = box(x, y);
        EXPECT_EQ(other.width, first.width) << x << " " << y;
        EXPECT_EQ(other.height(), first.height()) << x << " " << y;
    }
}

TEST_F(MathLayout, DecimalPointsStandAboveEachOther) {
    const MathBox box = value_box(style_, value_of(glm::dvec3(-12.5, 0.25, 3.0)), Ink::Plain);
    std::set<float> points;
    for (const MathBox::Text& text : box.texts)
        if (text.text.starts_with('.')) points.insert(text.at.x);
    EXPECT_EQ(points.size(), 1u);
}

TEST_F(MathLayout, ScriptsAreSmallerAndBesideTheLetter) {
    const Expression n = symbol(Symbol::NWorld, Meaning::InverseTranspose, std::nullopt);
    const MathBox box = expression_box(style_, transposed(n), kNames);
    ASSERT_EQ(box.texts.size(), 3u);  // n, world, T
    const auto &letter = box.texts[0], &below = box.texts[1], &above = box.texts[2];
    EXPECT_LT(below.size, letter.size);
    EXPECT_LT(above.size, letter.size);
    EXPECT_LT(above.at.y, below.at.y);
    EXPECT_LT(std::abs(above.at.x - below.at.x), 4.0f);  // above each other, not one after the other
}

TEST_F(MathLayout, ALetterAfterADigitIsNoNameInASentence) {
    style_.letters_in_text = style_.letters;
    const auto slanted = [&](std::string_view words) {
        std::string letters;
        for (const MathBox::Text& text : paragraph(style_, words, 1e9f, {}).texts)
            if (text.font == style_.letters) letters += text.text;
        return letters;
    };
    EXPECT_EQ(slanted("Next lesson: 1b. A normal in 3D, x to 2x"), "xx");
    style_.formula = true;
    EXPECT_EQ(slanted("4a²"), "a");
}

TEST_F(MathLayout, NoLineBreaksAtAnOperator) {
    style_.letters_in_text = style_.letters;
    const std::string_view sentence = "Better still, test that n · t = 0, for x² + y² = 1 and every n → n";
    for (float width = 120.0f; width < 600.0f; width += 7.0f) {
        const MathBox box = paragraph(style_, sentence, width, {});
        EXPECT_LE(box.width, width);
        for (std::size_t i = 1; i + 1 < box.texts.size(); ++i) {
            const std::string& sign = box.texts[i].text;
            if (sign != "·" && sign != "=" && sign != "→" && sign != "+") continue;
            EXPECT_GT(box.texts[i + 1].at.x, box.texts[i].at.x) << sign << " at " << width;
            EXPECT_LT(box.texts[i - 1].at.x, box.texts[i].at.x) << sign << " at " << width;
        }
    }
}

TEST_F(MathLayout, FindsWhatThePointerIsOn) {
    const Derivation d = derivation_of(kRunningExample);
    for (const Step& step : d.steps)
        for (const AsNumber* as : {&kNames, &kNumbers}) {
            const MathBox box = expression_box(style_, step.left(), *as);
            std::set<Place> places;
            for (const MathBox::Part& part : box.parts) {
                EXPECT_TRUE(places.insert(part.place).second);
                if (part.kind != Expression::Kind::Symbol) continue;
                const auto* found = part_at(box, {(part.low.x + part.high.x) / 2, (part.low.y + part.high.y) / 2});
                ASSERT_TRUE(found);
                EXPECT_EQ(found->place, part.place) << step.id;
            }
            EXPECT_FALSE(part_at(box, {-20, 0}));
            EXPECT_FALSE(part_at(box, {box.width / 2, box.descent + 20}));
        }
}

// An operator is hit where it stands apart from its operands: at its superscript.
TEST_F(MathLayout, SuperscriptsCanBeHit) {
    const Expression m3 = symbol(Symbol::M3, Meaning::Plain, value_of(kRunningExample));
    const MathBox box = expression_box(style_, transposed(m3), kNumbers);
    const auto& script = box.texts.back();
    ASSERT_EQ(script.text, "T");
    const auto* part = part_at(box, {script.at.x + 5, script.at.y + script.size / 2});
    ASSERT_TRUE(part);
    EXPECT_EQ(part->kind, Expression::Kind::Transpose);
}

TEST_F(MathLayout, WhatHasNoValueStaysAName) {
    const Derivation flat = derivation_of({{1, 0, 0}, {0, 0, 0}, {0, 0, 1}});
    for (const bool numbers : {false, true})
        for (const Passage& passage : passages(look_, flat, {.numbers = numbers, .switched = {}}, 0, kWidth)) {
            EXPECT_FALSE(passage.rows.empty());
            for (const Passage::Row& row : passage.rows) {
                EXPECT_LE(row.box.width, kWidth);
                for (const MathBox::Text& text : row.box.texts) {
                    EXPECT_EQ(text.text.find("nan"), std::string::npos);
                    EXPECT_EQ(text.text.find("inf"), std::string::npos);
                }
            }
        }
    const MathBox inverse =
        expression_box(style_, flat.steps.back().right(), [](Place, const Expression&) { return true; });
    EXPECT_FALSE(inverse.parts.back().has_number);
    EXPECT_FALSE(inverse.parts.back().as_number);
}

}  // namespace
}  // namespace normalscope

#include "core/explain/explanation.h"

#include "core/explain/latex.h"
#include "core/explain/text_box.h"
#include "core/lessons/open.h"
#include "core/scene/scene_json.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace normalscope {
namespace {

Probe probe_at(glm::dvec3 n) {
    n = glm::normalize(n);
    const glm::dvec3 t = glm::normalize(glm::cross(n, glm::dvec3(0.3, -0.5, 0.7)));
    return {{n}, {n}, {Vector<Object>{t}, Vector<Object>{glm::cross(n, t)}}};
}
Explanation explained(std::vector<StackEntry> stack, const std::optional<Probe>& probe = probe_at({1.0, 1.0, 0.0})) {
    Scene scene;
    scene.stack = std::move(stack);
    return explanation(scene, probe);
}
std::vector<std::string> classes_of(std::vector<StackEntry> stack) {
    std::vector<std::string> names;
    for (const MapClassRow& row : explained(std::move(stack)).classes)
        if (row.contains_m) names.emplace_back(name(row.map_class));
    return names;
}
const Step& step(const Explanation& e, std::string_view id) {
    return *std::ranges::find_if(e.derivation.steps, [&](const Step& s) { return s.id == id; });
}
using Names = std::vector<std::string>;

TEST(Explanation, NumbersThatMustComeOut) {
    const Explanation slide = explained({Scale{{0.5, 2.0, 1.0}}});
    EXPECT_NEAR(*slide.claims.worst_degrees, 61.928, 5e-4);
    EXPECT_NEAR(slide.decomposition.worst->degrees, 61.928, 5e-4);
    EXPECT_NEAR(*slide.derivation.checks[0].degrees_off, 61.928, 5e-4);  // the probe's normal is the worst one
    EXPECT_NEAR(*explained({Scale{{1.0, 2.0, 1.0}}}).claims.worst_degrees, 36.870, 5e-4);
}

TEST(Explanation, ReadsFromTheWishToTheRule) {
    const Explanation e = explained({Scale{{0.5, 2.0, 1.0}}});
    std::vector<std::string> lines;
    for (const Step& s : e.derivation.steps) lines.push_back(expression_text(s.line));
    EXPECT_EQ(lines,
              (Names{"n_obj · v_obj = 0", "n_world · v_world = 0", "n_world · (M₃ v_obj) = 0", "n_worldᵀ M₃ v_obj = 0",
                     "n_worldᵀ (M₃ᵀ)ᵀ v_obj = 0", "(M₃ᵀ n_world)ᵀ v_obj = 0", "(M₃ᵀ n_world) · v_obj = 0",
                     "M₃ᵀ n_world = n_obj", "n_world = (M₃ᵀ)⁻¹ n_obj", "n_world = (M₃⁻¹)ᵀ n_obj"}));
}

TEST(Explanation, ClassesOfMaps) {
    EXPECT_EQ(classes_of({}), (Names{"translation", "rotation"}));
    EXPECT_EQ(classes_of({Translate{{1, 2, 3}}}), (Names{"translation", "rotation"}));
    EXPECT_EQ(classes_of({Rotate{{1, 2, 3}, 40}, Translate{{1, 2, 3}}}), Names{"rotation"});
    EXPECT_EQ(classes_of({Scale{{2, 2, 2}}}), Names{"uniform scale"});
    EXPECT_EQ(classes_of({Scale{{-1, 1, 1}}}), Names{"reflection"});
    EXPECT_EQ(classes_of({Scale{{-2, -2, -2}}}), (Names{"uniform scale", "reflection"}));
    EXPECT_EQ(classes_of({Scale{{0.5, 2, 1}}}), Names{"uneven scale"});
    EXPECT_EQ(classes_of({Scale{{-1, 2, 1}}}), (Names{"reflection", "uneven scale"}));
    EXPECT_EQ(classes_of({Shear{.xy = 0.8}}), Names{"shear"});
    EXPECT_EQ(classes_of({Scale{{1, 1, 0}}}), Names{"singular"});
    EXPECT_EQ(classes_of({Scale{{0.5, 2, 1}}, Rotate{{1, 2, 3}, 30}}), Names{"general"});
    glm::dmat4 projective(1.0);
    projective[2].w = -0.5;
    EXPECT_EQ(classes_of({Matrix{projective}}), Names{"not affine"});
}

TEST(Explanation, ClaimsAreComputed) {
    const auto of = [](const glm::dvec3& factors) { return explained({Scale{factors}}).claims; };
    EXPECT_EQ(of({2, 2, 2}).naive_direction_right, true);
    EXPECT_EQ(of({2, 2, 2}).naive_length_right, false);
    EXPECT_EQ(of({-1, 1, 1}).naive_direction_right, true);
    EXPECT_EQ(of({-1, 1, 1}).cofactor, CofactorGives::OppositeDirection);
    EXPECT_EQ(of({1, 2, 1}).naive_direction_right, false);
    EXPECT_EQ(of({1, 2, 0}).cofactor, CofactorGives::OnlyOneThatExists);
    EXPECT_EQ(of({1, 2, 0}).worst_degrees, 90.0);
    EXPECT_EQ(of({1, 0, 0}).cofactor, CofactorGives::Zero);
    EXPECT_FALSE(of({1, 0, 0}).naive_direction_right.has_value());
    EXPECT_NEAR(*of({1, 1e6, 1}).digits_lost, 6.0, 1e-9);
}

TEST(Explanation, FlattenedStopsWhereTheInverseIsMissing) {
    const Explanation flat = explained({Scale{{1, 1, 0}}}, probe_at({0.3, 0.4, 1.0}));
    EXPECT_EQ(flat.derivation.n_world_by, Rule::Cofactor);
    EXPECT_EQ(step(flat, "as-dot-product").state, Step::State::Holds);
    EXPECT_EQ(step(flat, "same-direction").state, Step::State::Fails);
    EXPECT_NE(step(flat, "same-direction").remark, "");
    EXPECT_EQ(step(flat, "rule").state, Step::State::NoValue);
    // The tangent plane stands upright on the plane that all is flattened to: only a line is left of it.
    EXPECT_FALSE(explained({Scale{{1, 1, 0}}}, probe_at({1.0, 0.0, 0.0})).derivation.n_world_by.has_value());
    EXPECT_FALSE(explained({Scale{{1, 0, 0}}}).derivation.n_world_by.has_value());
    EXPECT_EQ(step(explained({}, std::nullopt), "given").state, Step::State::NoValue);
}

TEST(Explanation, VectorsDoNotSeeTheTranslation) {
    const HomogeneousDemo demo = explained({Translate{{1, 2, 3}}}).derivation.homogeneous;
    for (int r = 0; r < 4; ++r) EXPECT_EQ((*demo.after[1])(r, 0), (*demo.before[1])(r, 0));
    EXPECT_EQ((*demo.after[0])(0, 0), (*demo.before[0])(0, 0) + 1.0);
}

TEST(Explanation, OnlyTheOriginalOrderIsRight) {
    const Explanation e = explained({Scale{{0.5, 2, 1}}, Rotate{{1, 2, 3}, 30}, Shear{.xy = 0.7}});
    for (const OrderOfInverses& order : e.orders) {
        EXPECT_EQ(order.is_right, order.id == "right" || order.id == "neither-reversed") << order.id;
        EXPECT_EQ(*order.degrees_off < 1e-6, order.is_right) << order.id;
    }
}

TEST(Explanation, EntriesThatCommute) {
    const auto is_said = [](std::vector<StackEntry> stack) { return commute(stack); };
    EXPECT_TRUE(is_said({Scale{{0.5, 2, 1}}}));
    EXPECT_TRUE(is_said({Scale{{0.5, 2, 1}}, Translate{{1, 2, 3}}, Scale{{1, 3, -1}}}));
    EXPECT_TRUE(is_said({Rotate{{1, 2, 3}, 30}, Scale{{2, 2, 2}}, Rotate{{1, 2, 3}, 50}}));
    EXPECT_FALSE(is_said({Scale{{0.5, 2, 1}}, Rotate{{0, 0, 1}, 30}}));
    // The same backwards, and yet not in any order.
    EXPECT_FALSE(is_said({Shear{.xy = 0.7}, Scale{{0.5, 2, 1}}, Shear{.xy = 0.7}}));
}

TEST(Explanation, ReflectionsAreNamed) {
    const Decomposition mirror = explained({Scale{{1, -2, 1}}}).decomposition;
    EXPECT_TRUE(mirror.reflects);
    EXPECT_EQ(mirror.degrees, 0.0);
    EXPECT_EQ(mirror.axis, glm::dvec3(0, 1, 0));
}

TEST(Explanation, AHundredEntries) {
    const std::vector<StackEntry> stack(100, Rotate{{0.0, 0.6, 0.8}, 3.6});
    const Explanation e = explained(stack);
    EXPECT_EQ(e.stack.size(), 100U);
    for (int r = 0; r < 3; ++r)  // once around: the identity, and its rounding is not shown
        for (int c = 0; c < 3; ++c) EXPECT_EQ(number_text(e.m, r, c), r == c ? "1" : "0");
}

TEST(Explanation, RoundingOfZeroIsZero) {
    EXPECT_EQ(number_text(1e-17, 1e-16), "0");
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(-1.5e-8), "-1.5e-8");
    EXPECT_EQ(number_text(0.75909), "0.7591");
    EXPECT_EQ(number_text(12345.678), "12345.7");
    EXPECT_EQ(number_text(2.5e10), "2.5e10");
    EXPECT_EQ(number_text(100.0), "100");
    EXPECT_EQ(number_text(999999.99, 0.0, 3), "1000000");
}

TEST(Explanation, TextLinesUp) {
    const TextBox box = matrix_box(value_of(glm::dmat3(1.0, -0.25, 0.0, 10.5, 2.0, 0.0, 0.0, 0.0, -1.0)));
    EXPECT_EQ(box.lines, (Names{"⎡  1     10.5   0 ⎤", "⎢ -0.25   2     0 ⎥", "⎣  0      0    -1 ⎦"}));
    for (const std::string& line : box.lines) EXPECT_EQ(columns(line), box.width);
}

TEST(Explanation, AnyTextIsLatex) {
    EXPECT_EQ(latex_text("50% of {a_b} & #1^2~\\"),
              "50\\% of \\{a\\_b\\} \\& \\#1\\textasciicircum{}2\\textasciitilde{}\\textbackslash{}");
    EXPECT_EQ(latex_text("(M₃⁻¹)ᵀ é 日\n"), "(M$_3$$^{-1}$)$^{\\mathsf T}$ é ? ");
    EXPECT_EQ(latex_text("\xE6\x97"), "?");  // cut off
    EXPECT_EQ(latex_text("p′ Ω"), "p$'$ $\\Omega$");
    EXPECT_EQ(latex_number(-1.5e-8), "-1.5 \\cdot 10^{-8}");
}

TEST(Explanation, FitsATerminal) {
    for (const BuiltInScene& scene : built_in_scenes()) {
        std::string text = explain(load_scene(scene.name), ExplainFormat::Text);
        for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
            EXPECT_LE(columns(std::string_view(text).substr(0, end)), 100U) << scene.name;
    }
}

}  // namespace
}  // namespace normalscope

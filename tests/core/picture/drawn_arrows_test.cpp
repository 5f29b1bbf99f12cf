#include "core/frame/drawn_arrows.h"

#include "core/picture/make_frame.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace normalscope;

namespace {

Frame frame_of(const Scene& scene) {
    SurfaceCache surfaces;
    return make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {640, 480}}});
}
std::vector<std::string> angles(const Frame& frame) {
    std::vector<std::string> texts;
    for (const Pane& pane : frame.panes)
        for (const Label& label : pane.labels)
            if (label.text.ends_with(" off")) texts.push_back(label.text);
    return texts;
}

}  // namespace

TEST(DrawnArrows, TheCofactorsIsThereWhereItAloneGivesANormal) {
    Scene scene{.stack = {Scale{{1.0, 0.0, 1.0}}}};
    const auto has_cofactor = [&](Rule rule) {
        return std::ranges::count(drawn_arrows(scene, world_from_object(scene), rule), ArrowKind::Cofactor) > 0;
    };
    EXPECT_TRUE(has_cofactor(Rule::InverseTranspose));
    EXPECT_TRUE(has_cofactor(Rule::Naive));
    scene.view = ViewMode::Split;
    EXPECT_TRUE(has_cofactor(Rule::InverseTranspose));
    EXPECT_FALSE(has_cofactor(Rule::Naive));
    scene.view = ViewMode::Overlay;
    scene.arrows.show = std::vector{ArrowKind::InverseTranspose};
    EXPECT_FALSE(has_cofactor(Rule::InverseTranspose));  // as one has asked
    scene.arrows.show.reset();
    for (const glm::dvec3& factors : {glm::dvec3(1.0, 2.0, 1.0), glm::dvec3(1.0, 0.0, 0.0)}) {
        scene.stack = {Scale{factors}};
        EXPECT_FALSE(has_cofactor(Rule::InverseTranspose));
    }
}

TEST(DrawnArrows, InTheSplitViewTheNaiveRuleStandsAtTheLeft) {
    Scene scene{.view = ViewMode::Split};
    for (const Rule rule : {Rule::Naive, Rule::InverseTranspose, Rule::Cofactor}) {
        scene.rule = rule;
        const std::vector<Rule> rules = pane_rules(scene);
        EXPECT_EQ(rules, (std::vector{Rule::Naive, rule == Rule::Naive ? Rule::InverseTranspose : rule}));
        EXPECT_FALSE(can_choose(scene, Rule::Naive));
        EXPECT_TRUE(can_choose(scene, Rule::Cofactor));
    }
    scene.mistake = Mistake::TangentsByCofactor;
    EXPECT_TRUE(can_choose(scene, Rule::Naive));
    scene.view = ViewMode::Single;
    EXPECT_TRUE(can_choose(scene, Rule::Naive));
}

TEST(DrawnArrows, OneAngleWithItsName) {
    Scene scene{.stack = {Scale{{0.5, 2.0, 1.0}}}, .probe = Point<Object>{{0.6, 0.6, 0.5}}};
    const std::vector<std::string> overlay = angles(frame_of(scene));
    ASSERT_EQ(overlay.size(), 1u);
    EXPECT_TRUE(overlay[0].starts_with("M n: "));
    // The same by itself, where no right arrow stands beside it.
    scene.view = ViewMode::Single;
    scene.rule = Rule::Naive;
    EXPECT_EQ(angles(frame_of(scene)), overlay);
    scene.view = ViewMode::Split;
    EXPECT_EQ(angles(frame_of(scene)), overlay);
    scene.rule = Rule::InverseTranspose;
    scene.view = ViewMode::Single;
    EXPECT_TRUE(angles(frame_of(scene)).empty());
}

TEST(DrawnArrows, TheKeyNamesWhatIsShown) {
    Scene scene{.stack = {Scale{{0.5, 2.0, 1.0}}}};
    EXPECT_FALSE(frame_of(scene).color_key);
    scene.color = SurfaceColor::Error;
    EXPECT_EQ(frame_of(scene).color_key->text, "naive rule’s error");
    scene.mistake = Mistake::WOne;
    EXPECT_EQ(frame_of(scene).color_key->text, "error: w = 1");
    scene.color = SurfaceColor::Normals;
    EXPECT_EQ(frame_of(scene).color_key->of, SurfaceColor::Normals);
}

#include "core/scene/setting.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace normalscope {
namespace {

template <class F>
std::string message_of(F&& f) {
    try {
        f();
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

TEST(Setting, DeepNestingIsAnError) {
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    EXPECT_NE(message_of([&] { with_setting(Scene{}, "probe=" + deep); }).find("deep"), std::string::npos);
}

TEST(Setting, ChangesOneValue) {
    Scene scene;
    scene.stack = {Scale{{1, 2, 3}}};
    EXPECT_EQ(with_setting(scene, "rule=naive").rule, Rule::Naive);
    EXPECT_EQ(with_setting(scene, "rule=\"naive\"").rule, Rule::Naive);
    EXPECT_EQ(std::get<Scale>(with_setting(scene, "stack.0.scale=[4,5,6]").stack[0]).factors, glm::dvec3(4, 5, 6));
    EXPECT_EQ(std::get<Scale>(with_setting(scene, "stack.0.scale.1=-1e-3").stack[0]).factors, glm::dvec3(1, -1e-3, 3));
    EXPECT_EQ(std::get<Rotate>(with_setting(scene, R"(stack.1={"rotate":{"degrees":45}})").stack[1]).degrees, 45.0);
    EXPECT_EQ(with_setting(scene, "stack.0.translate=[1,0,0]").stack[0], StackEntry{(Translate{{1, 0, 0}})});
    EXPECT_TRUE(with_setting(scene, "stack=[]").stack.empty());
    EXPECT_EQ(std::get<MeshSurface>(with_setting(scene, "surface.mesh=a=b.obj").surface).mesh, "a=b.obj");
    EXPECT_EQ(std::get<ShapeSurface>(with_setting(scene, "surface.shape=cone").surface).shape, Shape::Cone);
    EXPECT_EQ(with_setting(scene, "probe=[1,2,3]").probe, Point<Object>{(glm::dvec3(1, 2, 3))});
    EXPECT_EQ(with_setting(with_setting(scene, "probe=[1,2,3]"), "probe=null"), scene);
    EXPECT_EQ(with_setting(scene, "arrows.show=[\"naive\"]").arrows.show, std::vector{ArrowKind::Naive});
    EXPECT_EQ(with_setting(scene, "show.grid=false").show.grid, false);
    EXPECT_EQ(with_setting(scene, "about=two words").about, "two words");
}

TEST(Setting, ErrorsNameThePath) {
    Scene scene;
    scene.stack = {Scale{{1, 2, 3}}};
    for (const char* text : {"rule", "=naive", ""}) EXPECT_THROW(with_setting(scene, text), UsageError) << text;
    for (const auto& [text, says] : std::vector<std::pair<const char*, const char*>>{
             {"rule=wrong", "rule"},
             {"rules=naive", "unknown key"},
             {"arrows.len=1", "arrows.len"},
             {"stack.3.scale=[1,1,1]", "stack.3"},
             {"stack.x.scale=[1,1,1]", "stack.x"},
             {"stack.0.scale.1=two", "stack.0.scale.1"},
             {"stack.0.scale.3=2", "stack.0.scale.3"},
             {"stack.0.scale=1e999", "1e999 is too large"},
             {"camera={\"zoom\": 1, \"zoom\": 2}", "camera: zoom: is there twice"},
             {"about=[", "a bracket or a quote is missing"},
             {"rule.naive=1", "rule.naive"},
             {"stack.1=1", "stack.1"},
             {"camera..zoom=1", "camera..zoom"},
             {".=1", "--set .: expected keys"},
             {"stack.=1", "--set stack.: expected keys"},
             {"camera.zoom=NaN", "camera.zoom"}}) {
        EXPECT_THROW(with_setting(scene, text), UsageError) << text;
        const std::string message = message_of([&, t = text] { with_setting(scene, t); });
        EXPECT_TRUE(message.starts_with("--set ")) << message;
        EXPECT_NE(message.find(says), std::string::npos) << text << "\n" << message;
    }
}

TEST(Setting, BetweenTwoScenesMakesOneOfTheOther) {
    const Scene from;
    Scene to;
    to.rule = Rule::Naive;
    to.stack = {Scale{{1, 2, 3}}, Rotate{{0, 0, 1}, 30}};
    to.slice = Slice{};
    to.surface = MeshSurface{"a 'quoted' name\xff.obj"};
    Scene made = from;
    std::vector<std::string> texts;
    for (const Setting& setting : settings_between(from, to)) {
        made = with_setting(made, setting);
        texts.push_back(setting.text());
    }
    EXPECT_EQ(made, to);
    EXPECT_EQ(std::ranges::count(texts, "rule=naive"), 1) << "a name needs no quotes";
    EXPECT_TRUE(settings_between(to, to).empty());
}

}  // namespace
}  // namespace normalscope

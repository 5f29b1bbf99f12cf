#include "core/scene/scene_json.h"
#include "core/lessons/open.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

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

TEST(SceneJson, MissingKeysTakeDefaults) {
    EXPECT_EQ(parse_scene("{}", "x"), Scene{});
    EXPECT_EQ(parse_scene(
                  R"({"normalscope": 1, "arrows": {}, "camera": {"zoom": null}, "surface": {"shape": "sphere"}})", "x"),
              Scene{});
}

TEST(SceneJson, ReadsTheDesignsExample) {
    const Scene scene = parse_scene(R"({
        "normalscope": 1, "surface": {"shape": "torus"},
        "stack": [{"scale": [0.5, 2, 1]}, {"rotate": {"axis": [0, 0, 1], "degrees": 30}}],
        "rule": "naive", "view": "split", "arrows": {"at": "faces", "every": 3, "length": 0.12},
        "camera": {"azimuth": 30, "elevation": 20, "zoom": 1}})",
                                    "x");
    EXPECT_EQ(std::get<ShapeSurface>(scene.surface).shape, Shape::Torus);
    ASSERT_EQ(scene.stack.size(), 2u);
    EXPECT_EQ(scene.stack[0], StackEntry{(Scale{{0.5, 2, 1}})});
    EXPECT_EQ(scene.stack[1], StackEntry{(Rotate{{0, 0, 1}, 30})});
    EXPECT_EQ(scene.rule, Rule::Naive);
    EXPECT_EQ(scene.view, ViewMode::Split);
    EXPECT_EQ(scene.arrows.at, ArrowPlacement::Faces);
    EXPECT_EQ(scene.arrows.every, 3);
}

TEST(SceneJson, MatricesAreArraysOfRows) {
    const Scene scene = parse_scene(R"({"stack": [{"matrix": [[1,2,3,4],[5,6,7,8],[9,10,11,12],[0,0,0,1]]}]})", "x");
    EXPECT_EQ(std::get<Matrix>(scene.stack[0]).matrix[3], glm::dvec4(4, 8, 12, 1));
}

struct Bad {
    const char* text;
    std::vector<const char*> says;
};

TEST(SceneJson, ErrorsNameThePath) {
    const std::string thousand = [] {
        std::string text = R"({"stack": [)";
        for (int i = 0; i < 1000; ++i) text += std::string(i ? "," : "") + R"({"scale": [1, 1, 1]})";
        return text + "]}";
    }();
    const std::string long_key = "{\"" + std::string(100'000, 'k') + "\": 1}",
                      no_json = "[" + std::string(100'000, 'x');
    std::string overflow = R"({"stack": [)";
    for (int i = 0; i < 100; ++i) overflow += std::string(i ? "," : "") + R"({"scale": [1e9, 1, 1]})";
    overflow += "]}";
    const std::vector<Bad> bad{
        {"", {"not valid JSON"}},
        {"[1, 2]", {"object"}},
        {"nonsense", {"not valid JSON"}},
        {R"({"rule": "naive")", {"not valid JSON"}},
        {R"({"power": 1.5})", {"power", "-1", "1"}},
        {R"({"colour": 1})", {"colour", "unknown key", "camera"}},
        {R"({"arrows": {"len": 1}})", {"arrows.len", "unknown key", "length"}},
        {R"({"rule": "correct"})", {"rule", "naive, inverse-transpose, cofactor", "correct"}},
        {R"({"rule": 1})", {"rule", "naive"}},
        {R"({"surface": {"shape": "blob"}})", {"surface.shape", "dodecahedron"}},
        {R"({"surface": {"shape": "cube", "mesh": "a.obj"}})", {"surface", "both shape and mesh"}},
        {R"({"surface": {}})", {"surface", "shape, mesh"}},
        {R"({"surface": {"shape": "cube", "resolution": 2}})", {"surface.resolution", "out of range"}},
        {R"({"surface": {"shape": "cube", "resolution": 10.5}})", {"surface.resolution", "whole"}},
        {R"({"surface": {"mesh": 5}})", {"surface.mesh", "string"}},
        {R"({"stack": {"scale": [1, 1, 1]}})", {"stack", "array"}},
        {R"({"stack": [{"scale": [1, 1]}]})", {"stack.0.scale", "3 numbers"}},
        {R"({"stack": [{"scale": [1, "2", 1]}]})", {"stack.0.scale.1", "a number", "\"2\""}},
        {R"({"stack": [{"scale": [1, NaN, 1]}]})", {": stack.0.scale.1: NaN is not a number"}},
        {R"({"stack": [{"scale": [1, 1, -Infinity]}]})", {": stack.0.scale.2: -Infinity is not a number"}},
        {R"({"camera": {"zoom": 1e999}})", {": camera.zoom: 1e999 is too large"}},
        {R"({"rule": "naive", "rule": "cofactor"})", {": rule: is there twice"}},
        {R"({"stack": [{"rotate": {"degrees": 1, "axis": [0, 0, 1], "degrees": 2}}]})",
         {": stack.0.rotate.degrees: is"}},
        {R"({"surface": {"mesh": ""}})", {"surface.mesh", "empty"}},
        {R"({"stack": [{"scale": [1, 1e10, 1]}]})", {"stack.0.scale.1", "out of range"}},
        {R"({"stack": [{"scale": [1, null, 1]}]})", {"stack.0.scale.1", "a number"}},
        {R"({"stack": [{"scale": [1, 1, 1]}, {"twist": 1}]})", {"stack.1", "scale, rotate, translate, shear, matrix"}},
        {R"({"stack": [{"scale": [1, 1, 1], "rotate": {}}]})", {"stack.0", "both"}},
        {R"({"stack": [{"scale": [1, 1, 1], "x": 1}]})", {"stack.0", "scale"}},
        {R"({"stack": [{"rotate": {"axis": [0, 0, 0]}}]})", {"stack.0.rotate.axis", "zero"}},
        {R"({"stack": [{"matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,true]]}]})", {"stack.0.matrix.3.3"}},
        {thousand.c_str(), {"stack", "1000", "200", "multiply some"}},
        {long_key.c_str(), {"kkk…: unknown key"}},
        {no_json.c_str(), {"not valid JSON"}},
        {overflow.c_str(), {"stack", "must stay below 1e60", "smaller scales"}},
        {R"({"camera": {"zoom": 0}})", {"camera.zoom", "out of range"}},
        {R"({"camera": {"elevation": 91}})", {"camera.elevation", "-90", "90"}},
        {R"({"show": {"grid": 1}})", {"show.grid", "true or false"}},
        {R"({"arrows": {"show": ["naive", "other"]}})", {"arrows.show.1", "object, naive"}},
        {R"({"probe": [0, 0]})", {"probe", "3 numbers"}},
        {R"({"pinned": [[0, 0, 1], [0, 0]]})", {"pinned.1", "3 numbers"}},
        {R"({"pinned": [[0, 0, 1], [0, 0, 1], [0, 0, 1], [0, 0, 1], [0, 0, 1]]})", {"pinned", "5 points", "at most 4"}},
        {R"({"normalscope": 2})", {"normalscope", "format 2"}},
        {R"({"normalscope": "1"})", {"normalscope"}},
    };
    for (const Bad& b : bad) {
        const std::string message = message_of([&] { parse_scene(b.text, "lecture.json"); });
        EXPECT_TRUE(message.starts_with("lecture.json: ")) << b.text << "\n" << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_LT(message.size(), 300u) << message;
        for (const char* word : b.says)
            EXPECT_NE(message.find(word), std::string::npos) << b.text << "\n" << message << "\nlacks " << word;
    }
}

TEST(SceneJson, DeepNestingIsAnError) {
    const std::string deep(100'000, '['), closed = deep + std::string(100'000, ']');
    for (const std::string& text : {deep, closed, R"({"stack": )" + closed + "}", R"({"unknown": )" + closed + "}"})
        EXPECT_NE(message_of([&] { parse_scene(text, "x"); }).find("deep"), std::string::npos);
}

TEST(BuiltInScenes, AllReadBackAndSayWhatTheyShow) {
    const std::vector<BuiltInScene> scenes = built_in_scenes();
    std::set<std::string> names;
    for (const BuiltInScene& built_in : scenes) {
        names.insert(built_in.name);
        EXPECT_FALSE(built_in.about.empty()) << built_in.name;
        const Scene scene = load_scene(built_in.name);
        EXPECT_EQ(parse_scene(scene_text(scene), "x"), scene) << built_in.name;
        EXPECT_NO_THROW(world_from_object(scene));
    }
    for (const char* name : {"slide-scale", "split", "identity", "rotation", "uniform", "shear"})
        EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_TRUE(names.contains(std::string(kDefaultScene)));
    const std::string others = message_of([] { load_scene("no-such-scene"); });
    const std::string gallery = message_of([] { load_scene("implicit-?"); });
    EXPECT_NE(others.find("normalscope scenes"), std::string::npos) << others;
    for (const std::string& name : names) {
        const std::string& message = name.starts_with("implicit-") ? gallery : others;
        EXPECT_NE(message.find(name), std::string::npos) << message;
    }
}

TEST(SceneFile, MeshPathsAreRelativeToTheFile) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "normalscope scene test";
    std::filesystem::create_directories(folder / "meshes");
    Scene scene;
    scene.surface = MeshSurface{(folder / "meshes" / "a.obj").generic_string()};
    save_scene(scene, folder / "scene.json");
    EXPECT_NE(read_file(folder / "scene.json", 1 << 20).find("\"meshes/a.obj\""), std::string::npos);
    EXPECT_EQ(load_scene((folder / "scene.json").string()), scene);
    EXPECT_THROW(save_scene(scene, folder / "nowhere" / "scene.json"), InputError);
    EXPECT_THROW(save_scene(scene, folder), InputError);
    EXPECT_THROW(load_scene((folder / "missing.json").string()), InputError);
    EXPECT_EQ(std::get<MeshSurface>(load_scene("some/where.PLY").surface).mesh, "some/where.PLY");
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace normalscope

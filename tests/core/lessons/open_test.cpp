#include "core/lessons/open.h"

#include "core/base/error.h"
#include "core/lessons/link.h"
#include "core/lessons/scene_caption.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace normalscope {
namespace {

std::string message_of(const std::string& name) {
    try {
        (void)open_name(name);
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

class OpenTest : public testing::Test {
protected:
    OpenTest() { std::filesystem::create_directories(folder_); }
    ~OpenTest() override { std::filesystem::remove_all(folder_); }
    std::string file(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "normalscope open test";
};

TEST_F(OpenTest, SaysWhatANameIs) {
    const std::string scene = file("scene.json", R"({"rule": "naive", "surface": {"mesh": "m.obj"}})");
    const std::string lesson = file("lesson.JSON", R"({"lesson": "L", "steps": [{"caption": "a"}, {"caption": "b"}]})");
    ASSERT_TRUE(std::holds_alternative<Scene>(open_name(scene)));
    EXPECT_EQ(std::get<MeshSurface>(load_scene(scene).surface).mesh, (folder_ / "m.obj").generic_string());
    EXPECT_TRUE(std::holds_alternative<Scene>(open_name("split")));
    EXPECT_TRUE(std::holds_alternative<Scene>(open_name(link_of(Scene{}))));
    EXPECT_EQ(std::get<MeshFile>(open_name("no/such.STL")).file, "no/such.STL");
    EXPECT_FALSE(std::get<ExercisesName>(open_name("exercises")).seed);
    EXPECT_EQ(std::get<ExercisesName>(open_name("exercises:7")).seed, 7u);
    EXPECT_FALSE(std::get<OpenedLesson>(open_name(lesson)).step);
    EXPECT_EQ(std::get<OpenedLesson>(open_name(lesson + "#2")).step, 1u);
    for (const char* name : {"1-normal-as-a-point#3", "1-normal-as-a-point/3", "#1-normal-as-a-point/3"})
        EXPECT_EQ(std::get<OpenedLesson>(open_name(name)).step, 2u) << name;
    EXPECT_EQ(load_lesson(lesson).title, "L");
}

TEST_F(OpenTest, SaysWhatIsWrong) {
    const std::string scene = file("scene.json", "{}"), bad = file("bad.json", "{\"rule\": 3}");
    EXPECT_NE(message_of("").find("name is empty"), std::string::npos);
    EXPECT_NE(message_of("exercises:x").find("seed"), std::string::npos);
    EXPECT_EQ(message_of(scene + "#1"), scene + "#1: " + scene + " is a scene, which has no steps; leave out #1");
    EXPECT_TRUE(message_of(bad + "#1").starts_with(bad + ": rule: expected one of")) << message_of(bad + "#1");
    EXPECT_NE(message_of("2-naive-rule#0").find("or lesson ("), std::string::npos) << "there is no lesson of that name";
    EXPECT_NE(message_of("1-normal-as-a-point#0").find("steps 1 to"), std::string::npos);
    EXPECT_NE(message_of("1-normal-as-a-point/99").find("steps 1 to"), std::string::npos);
    EXPECT_NE(message_of(std::string("a\0.json", 7)).find("cannot hold a NUL"), std::string::npos);
    EXPECT_THROW(load_lesson(scene), InputError);
    EXPECT_THROW(load_lesson("split"), InputError);
}

TEST(SceneCaption, EndsAsASentenceDoes) {
    for (const BuiltInScene& scene : built_in_scenes())
        EXPECT_TRUE(said_of(load_scene(scene.name)).caption.ends_with('.')) << scene.name;
    Scene mine;
    for (const char* about : {"Look!", "…", "球。"}) {
        mine.about = about;
        EXPECT_EQ(said_of(mine).caption, about);
    }
}

}  // namespace
}  // namespace normalscope

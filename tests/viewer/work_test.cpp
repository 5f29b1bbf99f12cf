// No work is lost: what is unsaved is said, asked about, and offered again.

#include "core/scene/scene_json.h"
#include "viewer/hosted.h"

namespace normalscope {
namespace {

constexpr ImGuiKeyChord kCtrl = ImGuiMod_Ctrl;

class WorkTest : public ViewerTest {
protected:
    void start_from_file() {
        save_scene(light(), path("s.json"));
        start(load_scene(path("s.json")), path("s.json"));
    }
    void close() {
        viewer().close();
        settle();
    }
};

TEST_F(WorkTest, ADotInTheTitleWhileUnsaved) {
    start_from_file();
    EXPECT_EQ(host_.title, "s.json \u2013 Normalscope");
    key(ImGuiKey_C);
    EXPECT_EQ(host_.title, "\u2022 s.json \u2013 Normalscope");
    key(kCtrl | ImGuiKey_Z);
    EXPECT_FALSE(is_unsaved());
    keys({ImGuiKey_C, kCtrl | ImGuiKey_S});
    EXPECT_FALSE(is_unsaved());
    key(kCtrl | ImGuiKey_Z);
    EXPECT_TRUE(is_unsaved()) << "the file holds what was undone";
    key(kCtrl | ImGuiKey_Y);
    EXPECT_FALSE(is_unsaved());
}

TEST_F(WorkTest, LookingAroundIsNoWorkWhereThereIsNoFile) {
    start();
    keys({ImGuiKey_2, ImGuiKey_T});
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_C);
    EXPECT_TRUE(is_unsaved());
    start_from_file();
    key(ImGuiKey_T);
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_2);
    EXPECT_TRUE(is_unsaved()) << "the file holds the camera";
}

TEST_F(WorkTest, UndoBringsBackTheName) {
    start_from_file();
    open("shear");
    EXPECT_EQ(named(), "shear");
    key(ImGuiKey_C);
    keys({kCtrl | ImGuiKey_Z, kCtrl | ImGuiKey_Z});
    EXPECT_EQ(named(), "s.json");
    EXPECT_FALSE(is_unsaved());
    key(kCtrl | ImGuiKey_Y);
    EXPECT_EQ(named(), "shear");
}

TEST_F(WorkTest, AnUndoKeepsTheNameThatTheSceneWasSavedBy) {
    start();
    key(ImGuiKey_C);
    answer_dialog(ImGuiKey_S, path("new.json"));
    key(kCtrl | ImGuiKey_Z);
    EXPECT_EQ(named(), "new.json");
    EXPECT_TRUE(is_unsaved());
}

TEST_F(WorkTest, ClosingAsksAndStays) {
    start_from_file();
    key(ImGuiKey_C);
    close();
    EXPECT_TRUE(asked());
    const Scene before = scene();
    keys({ImGuiKey_N, ImGuiKey_I});  // nothing else goes on
    EXPECT_EQ(scene(), before);
    key(ImGuiKey_Escape);
    EXPECT_FALSE(asked());
    EXPECT_FALSE(host_.closed);
    close();
    click(Item("##question") / "Stay");
    EXPECT_FALSE(asked());
    EXPECT_FALSE(host_.closed);
}

TEST_F(WorkTest, ClosingDiscards) {
    start_from_file();
    keys({ImGuiKey_C, kCtrl | ImGuiKey_Q, ImGuiKey_D});
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("s.json")), light());
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, ClosingSaves) {
    start_from_file();
    keys({ImGuiKey_C, kCtrl | ImGuiKey_Q, ImGuiKey_Enter});
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("s.json")).rule, Rule::Cofactor);
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, ClosingSavesWhatHasNoNameYet) {
    start();
    keys({ImGuiKey_C, kCtrl | ImGuiKey_Q});
    click(Item("##question") / "Save");
    EXPECT_FALSE(host_.closed);
    EXPECT_TRUE(viewer().interface().dialog_shown());
    key(ImGuiKey_Escape);  // rather not
    answer_dialog(ImGuiKey_S, path("a.json"));
    EXPECT_FALSE(host_.closed);
    keys({ImGuiKey_N, kCtrl | ImGuiKey_Q, ImGuiKey_Enter});
    EXPECT_TRUE(host_.closed);
    EXPECT_EQ(load_scene(path("a.json")).rule, Rule::Naive);
}

TEST_F(WorkTest, WhereSavingFailsItStays) {
    start_from_file();
    key(ImGuiKey_C);
    std::filesystem::remove(path("s.json"));
    std::filesystem::create_directory(path("s.json"));
    keys({kCtrl | ImGuiKey_Q, ImGuiKey_Enter});
    EXPECT_FALSE(host_.closed);
    EXPECT_NE(message(), "");
}

TEST_F(WorkTest, LessonsAndExercisesArePlay) {
    start(light(), "3-when-naive-is-right");
    keys({ImGuiKey_PageDown, ImGuiKey_C});
    EXPECT_FALSE(is_unsaved());
    keys({ImGuiKey_Escape, ImGuiKey_Enter});  // yes, leave it
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_N);
    EXPECT_TRUE(is_unsaved());
    start(light(), "exercises:42");
    keys({ImGuiKey_LeftArrow, ImGuiKey_Enter});
    EXPECT_FALSE(is_unsaved());
    key(ImGuiKey_Escape);
    EXPECT_FALSE(is_unsaved());
    close();
    EXPECT_TRUE(host_.closed);
}

TEST_F(WorkTest, ClosingInAnExerciseAsksAboutTheSceneBefore) {
    start();
    key(ImGuiKey_C);
    const Scene work = scene();
    open("exercises:42");
    EXPECT_EQ(parse_scene(host_.kept, "kept"), work);
    close();
    EXPECT_TRUE(asked());
    EXPECT_EQ(scene(), work);
}

TEST_F(WorkTest, AMeshOpenedIntoUnsavedWorkIsUnsaved) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    start();
    open(path("a.obj"));
    EXPECT_FALSE(is_unsaved());
    start();
    key(ImGuiKey_C);
    open(path("a.obj"));
    EXPECT_TRUE(is_unsaved());
}

TEST_F(WorkTest, WhatIsUnsavedIsKeptOnceAChangeIsDone) {
    start_from_file();
    key(ImGuiKey_C);
    EXPECT_EQ(parse_scene(host_.kept, "kept"), scene());
    point(ground());
    press();
    point(ground() + glm::dvec2(30, 0));
    EXPECT_NE(parse_scene(host_.kept, "kept"), scene());
    release();
    EXPECT_EQ(parse_scene(host_.kept, "kept"), scene());
    key(kCtrl | ImGuiKey_S);
    EXPECT_EQ(host_.kept, "");
}

TEST_F(WorkTest, WhatAnEarlierSessionLeftIsOffered) {
    Scene left = light();
    left.rule = Rule::Cofactor;
    start(light(), "", {.scale = {}, .lessons = {}, .unsaved = left});
    EXPECT_TRUE(asked());
    EXPECT_EQ(scene(), light());
    key(ImGuiKey_Enter);
    EXPECT_EQ(scene(), left);
    EXPECT_TRUE(is_unsaved());
    expect_undo({light(), left});
    start(light(), "", {.scale = {}, .lessons = {}, .unsaved = left});
    key(ImGuiKey_Escape);
    EXPECT_EQ(scene(), light());
    EXPECT_FALSE(asked());
}

}  // namespace
}  // namespace normalscope

// Each key that help lists, and undo.

#include "viewer/hosted.h"
#include "viewer/scene_keys.h"

#include <functional>

namespace normalscope {
namespace {

constexpr ImGuiKeyChord kCtrl = ImGuiMod_Ctrl, kShift = ImGuiMod_Shift;

TEST_F(ViewerTest, EachKeyChangesOneThingAndIsAStepToUndo) {
    start(light("shear"));
    struct Row {
        ImGuiKey key;
        std::function<void(Scene&)> change;
    };
    const std::vector<Row> rows{
        {ImGuiKey_N, [](Scene& s) { s.rule = Rule::Naive; }},
        {ImGuiKey_C, [](Scene& s) { s.rule = Rule::Cofactor; }},
        {ImGuiKey_I, [](Scene& s) { s.rule = Rule::InverseTranspose; }},
        {ImGuiKey_E, [](Scene& s) { s.color = SurfaceColor::Error; }},
        {ImGuiKey_E, [](Scene& s) { s.color = SurfaceColor::Normals; }},
        {ImGuiKey_E, [](Scene& s) { s.color = SurfaceColor::Lit; }},
        {ImGuiKey_G, [](Scene& s) { s.show.ghost = true; }},
        {ImGuiKey_T, [](Scene& s) { s.theme = Theme::Dark; }},
        {ImGuiKey_V, [](Scene& s) { s.view = ViewMode::Split; }},
        {ImGuiKey_V, [](Scene& s) { s.view = ViewMode::Overlay; }},
        {ImGuiKey_V, [](Scene& s) { s.view = ViewMode::Flat; }},
        {ImGuiKey_V, [](Scene& s) { s.view = ViewMode::Single; }},
        {ImGuiKey_R, [](Scene& s) { s.stack = {Scale{}}; }},
        {ImGuiKey_1, [](Scene& s) { s.camera.azimuth = 0, s.camera.elevation = 0; }},
        {ImGuiKey_2, [](Scene& s) { s.camera.azimuth = 90, s.camera.elevation = 0; }},
        {ImGuiKey_3, [](Scene& s) { s.camera.azimuth = 0, s.camera.elevation = 90; }},
    };
    std::vector<Scene> scenes{scene()};
    if (scene().rule == Rule::Naive) key(ImGuiKey_I), scenes = {scene()};
    for (const Row& row : rows) {
        Scene expected = scene();
        row.change(expected);
        key(row.key);
        EXPECT_EQ(scene(), expected) << ImGui::GetKeyName(row.key);
        scenes.push_back(scene());
    }
    for (std::size_t i = scenes.size() - 1; i > 0; --i) {
        key(kCtrl | ImGuiKey_Z);
        EXPECT_EQ(scene(), scenes[i - 1]) << i;
    }
    for (std::size_t i = 1; i < scenes.size(); ++i) {
        key(i % 2 == 0 ? kCtrl | ImGuiKey_Y : kCtrl | kShift | ImGuiKey_Z);
        EXPECT_EQ(scene(), scenes[i]) << i;
    }
}

TEST_F(ViewerTest, OnAMacCmdDoesWhatCtrlDoesElsewhere) {
    start(light("shear"));
    const Scene before = scene();
    ImGui::GetIO().ConfigMacOSXBehaviors = true;
    key(ImGuiKey_N);
    ASSERT_NE(scene(), before);
    key(kCtrl | ImGuiKey_Z);
    EXPECT_NE(scene(), before);
    key(ImGuiMod_Super | ImGuiKey_Z);
    EXPECT_EQ(scene(), before);
    key(ImGuiMod_Super | ImGuiKey_L);
    EXPECT_NE(message().find("Cmd+V"), std::string::npos) << message();
}

TEST_F(ViewerTest, FasterThanFramesEachKeyIsStillAStep) {
    start();
    const Scene before = scene();
    for (const ImGuiKey key : {ImGuiKey_N, ImGuiKey_E, ImGuiKey_T}) {
        viewer().press(KeyPress{key});
        viewer().release(KeyPress{key});
    }
    settle();
    EXPECT_EQ(scene().theme, Theme::Dark);
    keys({kCtrl | ImGuiKey_Z, kCtrl | ImGuiKey_Z});
    EXPECT_NE(scene(), before);
    key(kCtrl | ImGuiKey_Z);
    EXPECT_EQ(scene(), before);
}

TEST_F(ViewerTest, UndoHasEndsAndForgetsWhatWasUndone) {
    start();
    const Scene first = scene();
    keys({kCtrl | ImGuiKey_Z, kCtrl | kShift | ImGuiKey_Z, kCtrl | ImGuiKey_Y});  // nothing to undo yet
    EXPECT_EQ(scene(), first);
    keys({ImGuiKey_N, ImGuiKey_E});
    const Scene last = scene();
    for (int i = 0; i < 4; ++i) key(kCtrl | ImGuiKey_Z);
    EXPECT_EQ(scene(), first);
    for (int i = 0; i < 4; ++i) key(kCtrl | ImGuiKey_Y);
    EXPECT_EQ(scene(), last);
    keys({kCtrl | ImGuiKey_Z, ImGuiKey_C});
    const Scene other = scene();
    EXPECT_EQ(other.rule, Rule::Cofactor);
    key(kCtrl | ImGuiKey_Y);
    EXPECT_EQ(scene(), other);
}

TEST_F(ViewerTest, AKeyThatIsHeldDoesNotSwitchBackAndForth) {
    start();
    const Scene before = scene();
    hold(ImGuiKey_T);
    EXPECT_NE(scene().theme, before.theme);
}

TEST_F(ViewerTest, FramingFillsThePicture) {
    Scene far = light();
    far.camera.zoom = 0.2;
    far.camera.target = {{3, 2, 1}};
    start(far);
    key(ImGuiKey_F);
    EXPECT_LT(glm::length(scene().camera.target.xyz), 0.01);
    const PixelRect& rect = viewer().frame()->rect;
    const double reach = rect.origin.y + 0.5 * rect.size.y - pixel({0, 2.3, 0}).y;  // the cube to drag by
    EXPECT_NEAR(reach / (0.5 * std::min(rect.size.x, rect.size.y)), 0.9, 0.06);
    expect_undo({far, scene()});
}

TEST_F(ViewerTest, HelpComesAndGoes) {
    start();
    const auto shown = [] {
        const ImGuiWindow* help = ImGui::FindWindowByName("##help");
        return help && help->Active;
    };
    key(ImGuiKey_F1);
    EXPECT_TRUE(shown());
    key(ImGuiKey_Escape);
    EXPECT_FALSE(shown());
    key(ImGuiKey_F1);
    key(ImGuiKey_F1);
    EXPECT_FALSE(shown());
}

TEST_F(ViewerTest, ThePanelComesAndGoes) {
    start();
    const int beside = viewer().frame()->rect.size.x;
    for (const ImGuiKey each : {ImGuiKey_Tab, ImGuiKey_H}) {
        key(each);
        EXPECT_EQ(viewer().frame()->rect.size.x, host_.size.x);
        key(each);
        EXPECT_EQ(viewer().frame()->rect.size.x, beside);
    }
}

TEST_F(ViewerTest, TheDerivationComesAndGoes) {
    start();
    key(ImGuiKey_D);
    EXPECT_TRUE(viewer().interface().derivation_shown());
    key(ImGuiKey_D);
    EXPECT_FALSE(viewer().interface().derivation_shown());
}

TEST_F(ViewerTest, LargerAndSmaller) {
    start();
    const int before = viewer().frame()->rect.origin.x;
    keys({kCtrl | ImGuiKey_Equal, kCtrl | ImGuiKey_KeypadAdd});
    EXPECT_NEAR(viewer().remembered().scale.interface, 1.21, 1e-9);
    EXPECT_GT(viewer().frame()->rect.origin.x, before);
    key(kCtrl | ImGuiKey_Minus);
    EXPECT_NEAR(viewer().remembered().scale.interface, 1.1, 1e-9);
    key(kCtrl | ImGuiKey_0);
    EXPECT_EQ(viewer().remembered().scale.interface, 1.0);
    EXPECT_EQ(viewer().frame()->rect.origin.x, before);
    EXPECT_EQ(viewer().remembered().scale.presenter, 1.0);
}

TEST_F(ViewerTest, FullScreenAndTheEnd) {
    start();
    key(ImGuiKey_F11);
    EXPECT_TRUE(host_.full);
    EXPECT_FALSE(lecture().presenting);
    key(ImGuiKey_F11);
    EXPECT_FALSE(host_.full);
    key(kCtrl | ImGuiKey_Q);
    EXPECT_TRUE(host_.closed);
    EXPECT_FALSE(asked());
}

TEST_F(ViewerTest, KeysAreTextInADialog) {
    start();
    const Scene before = scene();
    key(kCtrl | ImGuiKey_S);
    for (const ImGuiKey each : {ImGuiKey_N, ImGuiKey_V, ImGuiKey_T, ImGuiKey_1, ImGuiKey_F, ImGuiKey_H}) key(each);
    type("nvt1fh");
    key(ImGuiKey_Escape);
    EXPECT_FALSE(viewer().interface().dialog_shown());
    EXPECT_EQ(scene(), before);
}

TEST_F(ViewerTest, KeysDoNothingBehindADialogNotEvenBeforeItIsDrawn) {
    start();
    const Scene before = scene();
    for (const ImGuiKeyChord chord : {kCtrl | ImGuiKey_S, +ImGuiKey_C, +ImGuiKey_E, +ImGuiKey_T})
        viewer().press(KeyPress{static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_), chord & ImGuiMod_Mask_});
    settle();
    EXPECT_TRUE(viewer().interface().dialog_shown());
    key(ImGuiKey_Escape);
    EXPECT_EQ(scene(), before);
}

}  // namespace
}  // namespace normalscope

#include "core/lessons/open.h"
#include "core/lessons/tabs.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"
#include "ui/interface.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // ImGuiWindow

#include <string>

namespace normalscope {
namespace {

struct Screen {
    glm::ivec2 size;
    float scale;
};
// Projectors and notebooks, at what their monitors ask for and a little more.
constexpr Screen kScreens[]{{{1280, 720}, 1.0f},  {{1280, 720}, 2.0f},  {{1280, 800}, 2.5f},
                            {{1920, 1080}, 2.0f}, {{1920, 1080}, 3.0f}, {{3840, 2160}, 3.0f}};

class ScalesTest : public testing::TestWithParam<Screen> {
protected:
    ScalesTest() { ImGui::CreateContext(); }
    ~ScalesTest() override { ImGui::DestroyContext(); }

    Frame step() {
        const auto [size, scale] = GetParam();
        interface_.prepare(scene_.theme, scale);
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = ImVec2(static_cast<float>(size.x), static_cast<float>(size.y));
        io.DeltaTime = 1.0f / 60.0f;
        Frame frame =
            make_frame(scene_, surfaces_.get(scene_), {.rect = interface_.picture(size), .pixel_scale = scale});
        ImGui::NewFrame();
        interface_.draw(scene_, frame, {.can_undo = true, .can_redo = true, .errors = std::nullopt, .file = "test"});
        ImGui::Render();
        return frame;
    }

    Scene scene_;
    SurfaceCache surfaces_;
    Interface interface_;
};

INSTANTIATE_TEST_SUITE_P(Screens, ScalesTest, testing::ValuesIn(kScreens), [](const auto& one) {
    return std::to_string(one.param.size.x) + "At" + std::to_string(static_cast<int>(10 * one.param.scale));
});

// The legend, the keys of colours and the labels: half a word is worse than none.
TEST_P(ScalesTest, WordsStayInThePicture) {
    for (const std::string name : {"slide-scale", "split", "reflection", "implicit-torus"})
        for (const SurfaceColor color : {SurfaceColor::Lit, SurfaceColor::Error, SurfaceColor::Normals})
            for (const std::string tab : {"", "error"}) {
                scene_ = load_scene(name);
                scene_.color = color;
                interface_.show_tab(tab);
                step();
                const Frame frame = step();
                const ImVec2 low(static_cast<float>(frame.rect.origin.x), static_cast<float>(frame.rect.origin.y));
                for (const ImDrawVert& v : ImGui::GetBackgroundDrawList()->VtxBuffer) {
                    ASSERT_GE(v.pos.x, low.x) << name << tab;
                    ASSERT_GE(v.pos.y, low.y) << name << tab;
                    ASSERT_LE(v.pos.x, low.x + static_cast<float>(frame.rect.size.x)) << name << tab;
                    ASSERT_LE(v.pos.y, low.y + static_cast<float>(frame.rect.size.y)) << name << tab;
                }
            }
}

TEST_P(ScalesTest, DialogsShowTheirTitleAndTheirButtons) {
    for (const auto ask : {&Interface::ask_open, &Interface::ask_save_scene, &Interface::ask_save_picture}) {
        (interface_.*ask)();
        for (int i = 0; i < 4; ++i) step();
        const ImGuiWindow* const dialog = ImGui::FindWindowByName("##files");
        ASSERT_TRUE(dialog);
        EXPECT_EQ(dialog->ScrollMax.y, 0.0f);
        EXPECT_GE(dialog->Pos.x, 0.0f);
    }
}

TEST_P(ScalesTest, TheSceneSentenceIsNotCutOff) {
    for (const BuiltInScene& built_in : built_in_scenes()) {
        scene_ = load_scene(built_in.name);
        step();
        step();
        const ImGuiWindow* const strip = ImGui::FindWindowByName("##strip");
        if (!strip || !strip->WasActive) continue;
        for (const ImDrawVert& v : strip->DrawList->VtxBuffer)
            ASSERT_LE(v.pos.y, strip->Pos.y + strip->Size.y + 1.5f) << built_in.name;  // with the line below it
    }
}

TEST_P(ScalesTest, TheKeysAreNotCutOff) {
    interface_.toggle_help();
    for (int i = 0; i < 4; ++i) step();
    const ImGuiWindow* const help = ImGui::FindWindowByName("##help");
    ASSERT_TRUE(help);
    EXPECT_LE(help->ContentSize.x, help->WorkRect.GetWidth());
}

}  // namespace
}  // namespace normalscope

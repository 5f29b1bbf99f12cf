#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/scene/scene_json.h"
#include "core/surface/surface.h"
#include "ui/interface.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <random>

namespace normalscope {
namespace {

// The interface without a window, the derivation open.
class DerivationPanelTest : public testing::Test {
protected:
    DerivationPanelTest() {
        ImGui::CreateContext();
        scene_ = load_scene("slide-scale");
        interface_.show_derivation(true);
        for (int i = 0; i < 4; ++i) step();
    }
    ~DerivationPanelTest() override { ImGui::DestroyContext(); }

    void step() {
        interface_.prepare(scene_.theme, 1.0f);
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {1280, 720};
        io.DeltaTime = 1.0f / 60.0f;
        const Frame frame = make_frame(scene_, surfaces_.get(scene_), {.rect = interface_.picture({1280, 720})});
        ImGui::NewFrame();
        interface_.draw(scene_, frame, {.can_undo = true, .can_redo = true, .errors = std::nullopt, .file = "test"});
        ImGui::Render();
    }
    void point(float x, float y) {
        ImGui::GetIO().AddMousePosEvent(x, y);
        step();
        step();
    }
    void click(float x, float y) {
        point(x, y);
        for (const bool down : {true, false}) {
            ImGui::GetIO().AddMouseButtonEvent(ImGuiMouseButton_Left, down);
            step();
        }
    }
    void press(ImGuiKey key) {
        for (const bool down : {true, false}) {
            ImGui::GetIO().AddKeyEvent(key, down);
            step();
        }
    }
    // Where in the panel that symbol is found, from the top.
    std::optional<ImVec2> find(const Highlight& wanted) {
        for (int y = 80; y < 720; y += 4)
            for (int x = 860; x < 1260; x += 4) {
                const ImVec2 at(static_cast<float>(x), static_cast<float>(y));
                ImGui::GetIO().AddMousePosEvent(at.x, at.y);
                step();
                if (interface_.highlighted() == wanted) return at;
            }
        return std::nullopt;
    }
    std::size_t vertices() const { return static_cast<std::size_t>(ImGui::GetDrawData()->TotalVtxCount); }

    Scene scene_;
    SurfaceCache surfaces_;
    Interface interface_;
};

TEST_F(DerivationPanelTest, LeavesThePictureTheRest) {
    const PixelRect open = interface_.picture({1280, 720});
    EXPECT_EQ(open.origin.x + open.size.x, 1280 - 432);
    press(ImGuiKey_D);
    EXPECT_FALSE(interface_.derivation_shown());
    const PixelRect closed = interface_.picture({1280, 720});
    EXPECT_EQ(closed.origin.x + closed.size.x, 1280);
    press(ImGuiKey_D);
    EXPECT_TRUE(interface_.derivation_shown());
    EXPECT_GT(interface_.picture({500, 400}).size.x, 0);
}

TEST_F(DerivationPanelTest, SaysWhatIsPointedAt) {
    const auto at = find({.symbol = Symbol::NObject, .naive = false, .tangent = 0});
    ASSERT_TRUE(at);
    EXPECT_TRUE(find({.symbol = Symbol::VWorld, .naive = false, .tangent = 0}));
    point(600, 700);
    EXPECT_FALSE(interface_.highlighted());
}

TEST_F(DerivationPanelTest, AClickSwitchesASymbolToItsNumbers) {
    const Highlight n_world{.symbol = Symbol::NWorld, .naive = false, .tangent = 0};
    const auto at = find(n_world);
    ASSERT_TRUE(at);
    const auto also_below = [&] {
        point(at->x + 6, at->y + 40);
        return interface_.highlighted() == n_world;
    };
    EXPECT_FALSE(also_below());
    click(at->x + 6, at->y + 8);
    EXPECT_TRUE(also_below());  // three numbers in brackets, in place of a name
    click(at->x + 6, at->y + 8);
    EXPECT_FALSE(also_below());
}

TEST_F(DerivationPanelTest, ThePictureLightsUpItsSymbols) {
    point(600, 700);
    const std::size_t before = vertices();
    interface_.highlight(Highlight{Symbol::VObject});
    step();
    EXPECT_GT(vertices(), before);
    interface_.highlight(std::nullopt);
    step();
    EXPECT_EQ(vertices(), before);
}

TEST_F(DerivationPanelTest, UncoversLineByLine) {
    point(600, 700);
    const std::size_t all = vertices();
    click(1200, 102);  // "step by step"
    std::size_t before = vertices();
    EXPECT_LT(before, all);
    for (int i = 0; i < 4; ++i) {
        press(ImGuiKey_RightArrow);
        step();
        EXPECT_GT(vertices(), before) << i;
        before = vertices();
    }
    press(ImGuiKey_LeftArrow);
    step();
    EXPECT_LT(vertices(), before);
    for (int i = 0; i < 30; ++i) press(ImGuiKey_PageDown);  // there is nothing beyond the end
    for (int i = 0; i < 30; ++i) press(ImGuiKey_PageUp);
}

TEST_F(DerivationPanelTest, ChangesNoSceneWhateverIsClicked) {
    std::mt19937 random(3);
    const auto below = [&](unsigned n) { return static_cast<float>(random() % n); };
    for (const BuiltInScene& built_in : built_in_scenes()) {
        const Scene before = scene_ = load_scene(built_in.name);
        interface_.show_derivation(true);
        for (int i = 0; i < 12; ++i) {
            ImGui::GetIO().AddMouseWheelEvent(0.0f, below(9) - 4.0f);
            click(852 + below(424), 40 + below(680));
        }
        EXPECT_EQ(scene_, before) << built_in.name;
    }
}

TEST_F(DerivationPanelTest, RestsWhenNothingHappens) {
    point(600, 700);
    for (int i = 0; i < 60; ++i) step();
    EXPECT_TRUE(std::isinf(interface_.redraw_after()));
}

}  // namespace
}  // namespace normalscope

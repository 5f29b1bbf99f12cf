#include "screen/screen.h"

#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/scene/scene_json.h"
#include "core/surface/surface.h"
#include "gl/support.h"

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

namespace normalscope {
namespace {

constexpr glm::ivec2 kSize(320, 200);
constexpr PixelRect kPicture{{100, 20}, {220, 180}};

/// A round of Dear ImGui's beside a turning picture, and the frame that it is laid over.
struct Moment {
    double azimuth;
    std::string panel = "panel", label = "label";
    float label_x = 150.0f;
    Theme theme = Theme::Light;
    bool rough = false;
    bool popup = false;  ///< over both
    glm::ivec2 size = kSize;
};

class ScreenTest : public testing::Test {
protected:
    ScreenTest() {
        need_context();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().Fonts->Build();
    }
    ~ScreenTest() override {
        screen_.reset();
        ImGui::DestroyContext();
    }

    static void lay_out(const Moment& moment) {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = ImVec2(static_cast<float>(moment.size.x), static_cast<float>(moment.size.y));
        ImGui::NewFrame();
        ImGui::GetBackgroundDrawList()->AddText({moment.label_x, 60.0f}, IM_COL32(200, 0, 0, 255),
                                                moment.label.c_str());
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({100.0f, io.DisplaySize.y});
        ImGui::Begin("beside", nullptr, ImGuiWindowFlags_NoDecoration);
        ImGui::TextUnformatted(moment.panel.c_str());
        ImGui::End();
        if (moment.popup)
            ImGui::GetForegroundDrawList()->AddRectFilled({60.0f, 90.0f}, {160.0f, 120.0f}, IM_COL32_WHITE);
        ImGui::Render();
    }

    /// What `screen` shows then.
    std::vector<std::uint8_t> pixels(Screen& screen, const Moment& moment, bool new_screen) {
        Scene scene = load_scene(std::string(kDefaultScene));
        scene.theme = moment.theme;
        scene.camera.azimuth = moment.azimuth;
        PixelRect rect = kPicture;
        rect.size = moment.size - rect.origin;
        const Frame frame = make_frame(scene, surfaces_.get(scene), {.rect = rect});
        if (new_screen) screen.upload_fonts();
        lay_out(moment);
        screen.draw({.frame = frame, .rough = moment.rough}, moment.size);
        std::vector<std::uint8_t> result(4 * static_cast<std::size_t>(moment.size.x * moment.size.y));
        glReadPixels(0, 0, moment.size.x, moment.size.y, GL_RGBA, GL_UNSIGNED_BYTE, result.data());
        return result;
    }

    SurfaceCache surfaces_;
    std::optional<Screen> screen_;
};

TEST_F(ScreenTest, WhatStaysBesideThePictureIsAsIfItWereDrawnAgain) {
    const std::vector<Moment> moments{
        {.azimuth = 10},
        {.azimuth = 20},                      // the picture alone
        {.azimuth = 30, .label = "another"},  // and its label
        {.azimuth = 40, .panel = "changed"},  // what lies beside it
        {.azimuth = 50, .panel = "changed"},
        {.azimuth = 60, .panel = "changed", .label_x = 95.0f},  // a label across the edge
        {.azimuth = 70, .panel = "changed"},                    // and gone from there
        {.azimuth = 80, .panel = "changed", .popup = true},
        {.azimuth = 90, .panel = "changed"},
        {.azimuth = 95, .panel = "changed", .rough = true},
        {.azimuth = 98, .panel = "changed", .rough = true},
        {.azimuth = 99, .panel = "changed"},
        {.azimuth = 99, .panel = "changed", .theme = Theme::Dark},
        {.azimuth = 99, .panel = "changed", .theme = Theme::Dark, .size = {300, 190}},
        {.azimuth = 33, .panel = "changed", .theme = Theme::Dark, .size = {300, 190}},
    };
    std::vector<std::vector<std::uint8_t>> alone;
    for (const Moment& moment : moments) {
        screen_.emplace();
        alone.push_back(pixels(*screen_, moment, true));
        screen_.reset();
    }
    screen_.emplace();
    for (std::size_t i = 0; i < moments.size(); ++i)
        EXPECT_TRUE(pixels(*screen_, moments[i], i == 0) == alone[i]) << "moment " << i;
}

}  // namespace
}  // namespace normalscope

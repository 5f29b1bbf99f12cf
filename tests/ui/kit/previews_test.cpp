#include "ui/kit/previews.h"
#include "core/lessons/open.h"
#include "core/picture/preview.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <thread>

namespace normalscope {
namespace {

// Every scene of the gallery fills a good part of its tile and stays clear of most of the edge.
TEST(Preview, ShowsTheSurface) {
    int scenes = 0;
    for (const BuiltInScene& built_in : built_in_scenes()) {
        if (!built_in.name.starts_with(kGalleryPrefix)) continue;
        ++scenes;
        const Scene scene = load_scene(built_in.name);
        const Image image = preview(ImplicitSurface(std::get<FormulaSurface>(scene.surface)), scene.camera, 24);
        int covered = 0, at_edge = 0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                if (image.pixel(x, y)[3] < 128) continue;
                ++covered;
                at_edge += x == 0 || y == 0 || x == 23 || y == 23;
            }
        EXPECT_GT(covered, 24 * 24 / 8) << built_in.name;
        EXPECT_LT(at_edge, 60) << built_in.name;
    }
    EXPECT_EQ(scenes, 19);
}

TEST(Preview, GoesIntoTheFontAtlas) {
    ImGui::CreateContext();
    {
        ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
        Previews previews;
        previews.want({"implicit-sphere", "implicit-plane", "slide-scale"}, 16);
        EXPECT_TRUE(previews.needs_room());
        previews.reserve(atlas);
        atlas.Build();
        previews.place(atlas);
        EXPECT_FALSE(previews.needs_room());
        for (int i = 0; i < 10'000 && previews.busy(); ++i) {
            (void)previews.update(atlas);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ASSERT_TRUE(previews.tile(0) && previews.tile(1));
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
        const auto alpha = [&](std::size_t tile, float u, float v) {
            const Previews::Tile t = *previews.tile(tile);
            const auto x =
                static_cast<std::ptrdiff_t>((t.low.x + u * (t.high.x - t.low.x)) * static_cast<float>(width));
            const auto y =
                static_cast<std::ptrdiff_t>((t.low.y + v * (t.high.y - t.low.y)) * static_cast<float>(height));
            return pixels[4 * (y * width + x) + 3];
        };
        EXPECT_EQ(alpha(0, 0.5f, 0.5f), 255);
        EXPECT_EQ(alpha(0, 0.02f, 0.02f), 0);
        EXPECT_EQ(alpha(2, 0.5f, 0.5f), 0);  // no formula: an empty tile
        EXPECT_FALSE(previews.tile(3));
        // Another size begins anew, and what goes away while it draws does no harm.
        previews.want({"implicit-barth-sextic"}, 64);
        EXPECT_TRUE(previews.needs_room());
        EXPECT_FALSE(previews.tile(0));
    }
    ImGui::DestroyContext();
}

// Large tiles on a fine monitor are wider together than an atlas of few letters would be.
TEST(Preview, HasRoomAtAnySize) {
    for (const int side : {80, 90, 180, 400, 700}) {
        ImGui::CreateContext();
        ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
        Previews previews;
        previews.want({"implicit-sphere", "implicit-plane"}, side);
        previews.reserve(atlas);
        atlas.Build();
        EXPECT_TRUE(atlas.GetCustomRectByIndex(atlas.CustomRects.Size - 1)->IsPacked()) << side;
        EXPECT_TRUE(atlas.CustomRects[0].IsPacked()) << side;
        previews.place(atlas);
        ImGui::DestroyContext();
    }
}

}  // namespace
}  // namespace normalscope

// What many arrows hide of the surface that they stand on, as solid ones would.

#include "support.h"

#include "core/frame/frame.h"
#include "core/picture/make_frame.h"
#include "core/scene/setting.h"
#include "core/surface/surface.h"
#include "gl/renderer.h"
#include "gl/target.h"

#include <cstdint>
#include <memory>
#include <set>
#include <string>

namespace normalscope {
namespace {

constexpr glm::ivec2 kSize(300, 300);

// A flat square in the plane z = 0, with an arrow along z at each of its vertices.
std::shared_ptr<const Surface> sheet(std::uint32_t a_side) {
    auto surface = std::make_shared<Surface>();
    Mesh& mesh = surface->mesh;
    for (std::uint32_t j = 0; j < a_side; ++j)
        for (std::uint32_t i = 0; i < a_side; ++i) {
            mesh.positions.push_back({2.0 * i / (a_side - 1) - 1.0, 2.0 * j / (a_side - 1) - 1.0, 0.0});
            mesh.normals.push_back({0.0, 0.0, 1.0});
            if (i + 1 == a_side || j + 1 == a_side) continue;
            const std::uint32_t a = j * a_side + i;
            mesh.triangles.push_back({a, a + 1, a + a_side + 1});
            mesh.triangles.push_back({a, a + a_side + 1, a + a_side});
        }
    surface->arrows = vertex_sites(mesh);
    surface->area = 4.0;
    surface->extent = {1.0, 1.0, 0.0};
    return surface;
}

Image picture_of(const std::shared_ptr<const Surface>& surface, double azimuth) {
    Scene scene;
    for (const char* set : {"view=single", "stack=[]", "show.grid=false", "show.axes=false", "show.probe=false",
                            "show.tangent_plane=false", "arrows.show=[\"inverse-transpose\"]", "arrows.length=0.03"})
        scene = with_setting(scene, set);
    scene.camera = {.azimuth = azimuth, .elevation = 0.0, .zoom = 3.0};
    const Frame frame = make_frame(scene, surface, {.rect = {{0, 0}, kSize}});
    Target target(kSize, 1);
    Renderer renderer;
    renderer.draw(frame, target);
    return target.read();
}

double share_of_green(const std::shared_ptr<const Surface>& surface, double azimuth) {
    const Image image = picture_of(surface, azimuth);
    int green = 0, all = 0;
    for (int y = 100; y < 200; ++y)
        for (int x = 100; x < 200; ++x) {
            const std::uint8_t* pixel = image.pixel(x, y);
            green += pixel[1] > pixel[0] + 25 ? 1 : 0;
            ++all;
        }
    return static_cast<double>(green) / all;
}

// They stand so close that heads cover all of it; what is thin end-on would leave it bare.
TEST(ArrowField, ArrowsThatPointAtTheEyeHideTheSurface) {
    need_context();
    for (const std::uint32_t a_side : {230u, 550u}) {
        const auto surface = sheet(a_side);
        EXPECT_GT(share_of_green(surface, 0.0), 0.95) << surface->arrows.size() << " arrows from in front";
        EXPECT_GT(share_of_green(surface, 40.0), 0.95) << surface->arrows.size() << " arrows askew";
    }
}

// All point the same way in the same light: what tells them apart is that each has more or less of it than the next.
TEST(ArrowField, CrowdedArrowsDoNotMergeIntoASkin) {
    need_context();
    for (const std::uint32_t a_side : {150u, 230u}) {
        const Image image = picture_of(sheet(a_side), 40.0);
        std::set<std::uint8_t> greens;
        for (int y = 100; y < 200; ++y)
            for (int x = 100; x < 200; ++x)
                if (const std::uint8_t* pixel = image.pixel(x, y); pixel[1] > pixel[0] + 25) greens.insert(pixel[1]);
        ASSERT_FALSE(greens.empty());
        EXPECT_GT(*greens.rbegin() - *greens.begin(), 40) << a_side * a_side << " arrows";
        EXPECT_GT(greens.size(), 30u) << a_side * a_side << " arrows";
    }
}

}  // namespace
}  // namespace normalscope

#include "core/picture/way_of_drawing.h"

#include "core/lessons/open.h"
#include "core/picture/make_frame.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace normalscope {
namespace {

Frame frame_of(const std::string& formula) {
    Scene scene = load_scene("implicit-torus");
    scene.surface = FormulaSurface{.formula = formula, .bound = 2.0};
    return make_frame(scene, SurfaceCache().get(scene), {.rect = {{0, 0}, {400, 300}}});
}

bool is_noted(const Frame& frame) {
    return std::ranges::any_of(frame.notes,
                               [](const std::string& note) { return note.starts_with("the formula is so long"); });
}

TEST(WayOfDrawing, AVeryLongFormulaIsDrawnByItsTriangles) {
    std::string formula = "x^2 + y^2 + z^2 - 1", nested = "z";
    for (int i = 1; i <= 30; ++i)
        formula += " + 0.01*sin(" + std::to_string(i) + "*x)*cos(" + std::to_string(i) + "*y)";
    EXPECT_TRUE(is_traced(*frame_of(formula).surface));
    EXPECT_FALSE(is_noted(frame_of(formula)));
    for (int i = 0; i < 1000; ++i) nested = "sin(" + nested + ")";
    const Frame frame = frame_of(formula + " + " + nested);
    EXPECT_FALSE(is_traced(*frame.surface));
    EXPECT_FALSE(frame.panes.front().surfaces.front().traced_object_from_world);
    EXPECT_TRUE(is_noted(frame));
}

TEST(WayOfDrawing, EveryBuiltInFormulaIsTraced) {
    for (const BuiltInScene& built_in : built_in_scenes()) {
        const Scene scene = load_scene(std::string(built_in.name));
        const auto surface = SurfaceCache().get(scene);
        EXPECT_EQ(is_traced(*surface), surface->implicit != nullptr) << built_in.name;
    }
}

}  // namespace
}  // namespace normalscope

#include "core/frame/frame.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

Frame frame_of(const Scene& scene) {
    SurfaceCache surfaces;
    return make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {800, 600}}});
}

TEST(SingularMarks, AreAFanOnlyWhereNormalsPointToManySides) {
    const Scene cone = load_scene("implicit-cone");
    EXPECT_TRUE(frame_of(cone).fan);

    Scene hidden = cone;
    hidden.show.probe = false;
    EXPECT_FALSE(frame_of(hidden).fan);

    Scene touching = cone;  // whose gradient is zero all over, though its neighbours agree
    touching.surface = FormulaSurface{.formula = "(x^2 + y^2 + z^2 - 1)^2"};
    touching.probe = Point<Object>{{0.6, 0.8, 0}};
    const Frame frame = frame_of(touching);
    EXPECT_TRUE(frame.singular);
    EXPECT_FALSE(frame.fan);
}

}  // namespace
}  // namespace normalscope

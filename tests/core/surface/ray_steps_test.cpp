#include "core/surface/ray_steps.h"
#include "core/base/error.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace normalscope {
namespace {

RaySteps steps_of(const Scene& scene) {
    SurfaceCache surfaces;
    return ray_steps(scene, *surfaces.get(scene), world_from_object(scene), CameraView(scene.camera, {640, 480}));
}

// A moved and sheared ball: its image is an ellipsoid, whose quadric q = M⁻ᵀ diag(1, 1, 1, −1) M⁻¹ is met and
// differentiated in the world, without any object space.
TEST(RaySteps, AreWhatTheEllipsoidInTheWorldGives) {
    Scene scene;
    scene.stack = {Scale{{0.5, 1.5, 1.0}}, Shear{.xy = 0.4}, Rotate{{1.0, 2.0, 0.5}, 40.0},
                   Translate{{1.0, -0.5, 0.25}}};
    scene.ray = AimedRay{Point<World>{{3.0, 2.0, 4.0}}, Point<World>{{1.1, -0.4, 0.3}}};
    const glm::dmat4 inverse = glm::inverse(world_from_object(scene).matrix());
    glm::dmat4 ball(1.0);
    ball[3][3] = -1.0;
    const glm::dmat4 q = glm::transpose(inverse) * ball * inverse;
    const glm::dvec4 o(3.0, 2.0, 4.0, 1.0), d(glm::normalize(glm::dvec3(1.1, -0.4, 0.3) - glm::dvec3(o)), 0.0);
    const double a = glm::dot(d, q * d), b = glm::dot(d, q * o), c = glm::dot(o, q * o);
    const double t = (-b - std::sqrt(b * b - a * c)) / a;
    const glm::dvec3 gradient = 2.0 * glm::dvec3(q * (o + t * d));

    scene.surface = FormulaSurface{};
    const RaySteps s = steps_of(scene);
    EXPECT_EQ(s.end, RaySteps::End::Whole);
    ASSERT_TRUE(s.brightness);
    EXPECT_NEAR(*s.t, t, 1e-12);
    EXPECT_NEAR(glm::distance(s.point_world->xyz, glm::dvec3(o + t * d)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(world_from_object(scene)(*s.point).xyz, s.point_world->xyz), 0.0, 1e-12);
    EXPECT_NEAR(*s.f, 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(s.normal->xyz, gradient), 0.0, 1e-11);
    EXPECT_NEAR(*s.brightness, glm::dot(glm::normalize(gradient), s.toward_light.xyz), 1e-12);
    EXPECT_NEAR(*s.t_if_normalised, glm::length(inverse * d) * t, 1e-12);

    // The sphere's mesh is hit nearly there; its normal stands in the gradient's place.
    scene.surface = ShapeSurface{Shape::Sphere, 256};
    const RaySteps mesh = steps_of(scene);
    ASSERT_TRUE(mesh.brightness);
    EXPECT_FALSE(mesh.f);
    EXPECT_NEAR(*mesh.t, t, 1e-3);
    EXPECT_NEAR(*mesh.brightness, *s.brightness, 2e-3);
}

TEST(RaySteps, EndWhereThereIsNothingToFollow) {
    Scene scene;
    scene.surface = FormulaSurface{};
    scene.ray = AimedRay{Point<World>{{0.0, 0.0, 5.0}}, Point<World>{{0.2, 0.3, 0.0}}};
    scene.stack = {Scale{{1.0, 1.0, 0.0}}};
    RaySteps s = steps_of(scene);
    EXPECT_EQ(s.end, RaySteps::End::NoInverse);
    EXPECT_FALSE(s.object);
    ASSERT_TRUE(s.t);  // the flattened object is there to be hit all the same
    EXPECT_NEAR(s.point_world->xyz.z, 0.0, 1e-9);

    scene.stack.clear();
    scene.ray->toward = Point<World>{{3.0, 0.0, 0.0}};
    s = steps_of(scene);
    EXPECT_EQ(s.end, RaySteps::End::Misses);
    EXPECT_TRUE(s.object);
    EXPECT_FALSE(s.t);

    scene.surface = FormulaSurface{.formula = "x^2+z^2-y^2"};
    scene.ray = AimedRay{Point<World>{{0.0, 0.0, 3.0}}, Point<World>{}};
    s = steps_of(scene);
    EXPECT_EQ(s.end, RaySteps::End::NoNormal);
    EXPECT_EQ(s.last_step, 3);
    EXPECT_FALSE(s.gradient);

    glm::dmat4 bent(1.0);
    bent[2][3] = 0.2;
    scene.stack = {Matrix{bent}};
    EXPECT_EQ(steps_of(scene).end, RaySteps::End::NotAffine);
}

}  // namespace
}  // namespace normalscope

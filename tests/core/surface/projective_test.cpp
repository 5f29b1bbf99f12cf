#include "core/math/projective.h"

#include "core/math/stack.h"
#include "core/mesh/mesh.h"
#include "core/scene/scene.h"
#include "core/surface/error_measures.h"
#include "core/surface/mesh_probe.h"
#include "core/surface/shapes.h"
#include "core/surface/surface.h"
#include "core/surface/worst_dots.h"

#include "random.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace normalscope;

namespace {

glm::dmat4 random_affine(Random& random) {
    glm::dmat4 m(1.0);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r) m[c][r] = random.uniform(-2.0, 2.0);
    return m;
}
// Its w is between 0.2 and 3.5 on the unit ball.
glm::dmat4 random_projective(Random& random) {
    glm::dmat4 m = random_affine(random);
    for (int c = 0; c < 3; ++c) m[c].w = random.uniform(-0.4, 0.4);
    m[3].w = random.uniform(1.0, 2.5);
    return m;
}
// The project's own numbers for bottom row 0 0 0.3 1.
Scene projective_scene() {
    Scene scene;
    glm::dmat4 m(1.0);
    m[2].w = 0.3;
    scene.stack = {Matrix{m}};
    scene.probe = Point<Object>{{0.5, 0.5, 0.7}};
    return scene;
}

}  // namespace

TEST(Projective, NormalsStayPerpendicularToWhatBecomesOfTangents) {
    Random random(10);
    for (int i = 0; i < 2000; ++i) {
        const Transform<World, Object> m(random_projective(random));
        const Probe probe = probe_with({random.direction()}, {random.direction()});
        ASSERT_FALSE(m.affine());
        const auto n = m(probe.point, probe.normal);
        if (!n || std::abs(glm::determinant(m.matrix())) < 0.05) continue;
        for (const Vector<Object>& t : probe.tangents) {
            const Vector<World> sent = m(probe.point, t);
            EXPECT_NEAR(dot(*n, sent), 0.0, 1e-11 * glm::length(n->xyz) * glm::length(sent.xyz));
            // And they are what differences of the mapped points make of them.
            constexpr double kStep = 1e-5;
            const glm::dvec3 after = m(probe.point + kStep * t).xyz, before = m(probe.point + -kStep * t).xyz;
            EXPECT_LT(glm::distance((after - before) / (2.0 * kStep), sent.xyz), 1e-6 * (1.0 + glm::length(sent.xyz)));
        }
    }
}

// ∇(f ∘ M⁻¹) of a sphere's f, by differences in the world: its direction, and which side is outside.
TEST(Projective, TheNormalIsTheGradientOfWhatTheSurfaceBecomes) {
    Random random(11);
    for (int i = 0; i < 500; ++i) {
        const Transform<World, Object> m(random_projective(random));
        const auto back = m.inverse();
        if (!back || std::abs(glm::determinant(m.matrix())) < 0.2) continue;
        const Point<Object> p{random.direction()};
        const auto n = m(p, Normal<Object>{p.xyz});
        ASSERT_TRUE(n);
        const auto f = [&](const glm::dvec3& world) {
            const glm::dvec3 q = (*back)(Point<World>{world}).xyz;
            return glm::dot(q, q) - 1.0;
        };
        const glm::dvec3 at = m(p).xyz;
        glm::dvec3 gradient;
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 h(0.0);
            h[k] = 1e-6;
            gradient[k] = (f(at + h) - f(at - h)) / 2e-6;
        }
        EXPECT_LT(*angle_degrees(n->xyz, gradient), 1e-3);
    }
}

TEST(Projective, AnAffineMapIsAsItWas) {
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        const Transform<World, Object> m(random_affine(random));
        ASSERT_TRUE(m.affine());
        const Point<Object> p{random.direction()};
        const Normal<Object> n{random.direction()};
        EXPECT_EQ(m(p, n)->xyz, m(n)->xyz);
        EXPECT_EQ(m(p, Vector<Object>{n.xyz}).xyz, m(Vector<Object>{n.xyz}).xyz);
        EXPECT_EQ(m.at(p).matrix(), m.matrix());
        EXPECT_EQ(m.rank(), m.normal_matrices_by_rule().rank);
    }
}

TEST(Projective, ItsAffineMapNextToAPointHasTheSameNormal) {
    Random random(13);
    for (int i = 0; i < 300; ++i) {
        const Transform<World, Object> m(random_projective(random));
        if (std::abs(glm::determinant(m.matrix())) < 0.2) continue;
        const Point<Object> p{random.direction()};
        const Normal<Object> n{random.direction()};
        const Transform<World, Object> near = m.at(p);
        EXPECT_LT(glm::distance(near(p).xyz, m(p).xyz), 1e-12 * (1.0 + glm::length(m(p).xyz)));
        EXPECT_LT(glm::distance(near(n)->xyz, m(p, n)->xyz), 1e-9 * glm::length(m(p, n)->xyz));
        EXPECT_EQ(m.reflects(), near.normal_matrices_by_rule().determinant < 0.0);
    }
}

TEST(Projective, ACommonFactorOfAllEntriesChangesNothing) {
    const glm::dmat4 m = glm::scale(glm::translate(glm::dmat4(1.0), {1.0, 2.0, 3.0}), {0.5, 2.0, 1.0});
    for (const double s : {2.0, -3.0, 1e-3, 1e6}) {
        const Transform<World, Object> scaled(s * m);
        EXPECT_TRUE(scaled.affine());
        const Scene scene{.stack = {Matrix{s * m}}};
        EXPECT_TRUE(world_from_object(scene).affine());
        for (int c = 0; c < 4; ++c) EXPECT_LT(glm::distance(world_from_object(scene).matrix()[c], m[c]), 1e-12);
        EXPECT_NEAR(*world_from_object(scene).normal_matrices_by_rule().error_bound_degrees(), 61.928, 5e-4);
    }
    // A map and its inverse, of which rounding leaves a little.
    glm::dmat4 bent(1.0);
    bent[0].w = 0.1;
    bent[2].w = 0.3;
    EXPECT_TRUE(world_from_object(Scene{.stack = {Matrix{bent}, Matrix{glm::inverse(bent)}}}).affine());
}

TEST(Projective, NumbersAtTheProbe) {
    const Scene scene = projective_scene();
    SurfaceCache surfaces;
    const auto surface = surfaces.get(scene);
    const Transform<World, Object> m = world_from_object(scene);
    const auto probe = nearest_probe(surface->mesh, *scene.probe);
    const ProbeInWorld world = in_world(*probe, m, scene);
    ASSERT_TRUE(world.truth);
    const glm::dvec3 n = glm::normalize(world.truth->xyz);
    EXPECT_NEAR(n.x, 0.40868, 3e-3);
    EXPECT_NEAR(n.y, 0.40878, 3e-3);
    EXPECT_NEAR(n.z, 0.81601, 3e-3);
    EXPECT_NEAR(*world.error_degrees, 9.98, 0.05);
    EXPECT_FALSE(world.affine);
    double largest = 0.0, smallest = 1.0;
    for (const double d : *world.dots[0]) {
        largest = std::max(largest, std::abs(d));
        smallest = std::min(smallest, std::abs(d));
    }
    EXPECT_GT(smallest, 0.05);
    EXPECT_LT(largest, 0.2);
}

TEST(Projective, MeasuresOverASurfaceFollowTheTruth) {
    const Mesh sphere = make_shape({});
    const Transform<World, Object> m = world_from_object(projective_scene());
    const NormalMap naive{.matrix = glm::dmat4(1.0)};
    const auto errors = error_statistics(sphere, naive, m);
    ASSERT_TRUE(errors);
    double worst = 0.0, worst_dot = 0.0;
    for (std::size_t i = 0; i < sphere.normals.size(); ++i) {
        const Transform<World, Object> near = m.at({sphere.positions[i]});
        worst = std::max(worst, *angle_degrees(sphere.normals[i], near(Normal<Object>{sphere.normals[i]})->xyz));
        for (const Vector<Object>& t : probe_with({sphere.positions[i]}, {sphere.normals[i]}).tangents)
            worst_dot = std::max(worst_dot, std::abs(glm::dot(sphere.normals[i], glm::normalize(near(t).xyz))));
    }
    EXPECT_NEAR(errors->worst_degrees, worst, 1e-9);
    EXPECT_GT(worst, 9.0);
    EXPECT_NEAR(error_histogram(sphere, naive, m, 1'000'000)->worst_degrees, worst, 1e-9);
    const auto dots = worst_dots(sphere, {naive, std::nullopt, std::nullopt}, m);
    EXPECT_NEAR(*dots[0], worst_dot, 1e-9);
    EXPECT_FALSE(dots[1]);
}

TEST(Projective, WhatIsBeyondInfinityHasNoImage) {
    glm::dmat4 m(1.0);
    m[2].w = 2.0;  // w = 0 at z = −½
    const Transform<World, Object> t(m);
    EXPECT_TRUE(t.reaches({{0.0, 0.0, 0.0}}));
    EXPECT_FALSE(t.reaches({{0.0, 0.0, -0.5}}));
    EXPECT_FALSE(t.reaches({{0.0, 0.0, -1.0}}));
    EXPECT_FALSE(t({{0.0, 0.0, -1.0}}, Normal<Object>{{0.0, 0.0, -1.0}}));
    const Mesh sphere = make_shape({});
    const auto errors = error_statistics(sphere, {.matrix = glm::dmat4(1.0)}, t);
    ASSERT_TRUE(errors);
    EXPECT_TRUE(std::isfinite(errors->mean_degrees));
    const auto hit = first_hit(sphere, t, Ray<World>{{{0.0, 0.0, 9.0}}, {{0.0, 0.0, -1.0}}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->probe.point.xyz.z, 1.0, 1e-9);
    EXPECT_NEAR(hit->t, 9.0 - 1.0 / 3.0, 1e-9);
}

TEST(Projective, WithoutAnInverseThereMayStillBeANormal) {
    glm::dmat4 m(1.0);
    m[2] = glm::dvec4(0.0, 0.0, 0.0, 1.0);  // a pinhole camera's: (x, y, 0) / (z + 3)
    m[3] = glm::dvec4(0.0, 0.0, 0.0, 3.0);
    const Transform<World, Object> t(m);
    EXPECT_EQ(t.rank(), 2);
    EXPECT_FALSE(t.inverse());
    const Probe probe = probe_with({{0.6, 0.0, 0.8}}, {{0.6, 0.0, 0.8}});
    const ProbeInWorld world = in_world(probe, t);
    ASSERT_TRUE(world.truth);
    EXPECT_NEAR(std::abs(glm::normalize(world.truth->xyz).z), 1.0, 1e-12);
    EXPECT_FALSE(world.error_degrees);
    // M3 without an inverse, M with one.
    glm::dmat4 mixed(1.0);
    mixed[2] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    mixed[3] = glm::dvec4(0.0, 0.0, 1.0, 3.0);
    const Transform<World, Object> u(mixed);
    EXPECT_EQ(u.rank(), 3);
    EXPECT_TRUE(u.inverse());
    EXPECT_TRUE(u(probe.point, probe.normal));
    EXPECT_FALSE(u.normal_matrices_by_rule().inverse_transpose);
}

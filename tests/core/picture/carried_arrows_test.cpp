// What the picture shows of the derivation, against the derivation's own numbers.

#include "core/frame/carried_arrows.h"

#include "core/explain/derivation.h"
#include "core/picture/make_frame.h"
#include "random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace normalscope {
namespace {

glm::dvec3 vec(const Value& v) { return {v(0, 0), v(1, 0), v(2, 0)}; }

struct Case {
    Transform<World, Object> m;
    ProbeInWorld probe;
};
Case any(Random& random) {
    for (;;) {
        glm::dmat4 matrix(random.matrix(2.0));
        matrix[3] = glm::dvec4(random.vector(3.0), 1.0);
        const Transform<World, Object> m(matrix);
        if (m.rank() < 3 || *m.normal_matrices_by_rule().condition() > 100.0) continue;
        return {m, in_world(probe_with({random.vector()}, {random.direction()}), m)};
    }
}
const CarriedArrow& named(const CarriedArrows& shown, const std::string& name) {
    return *std::ranges::find(shown.arrows, name, &CarriedArrow::name);
}

// With a polygon in the probe's place v is one of its edges, from corner to corner.
TEST(CarriedArrows, AnEdgeOfHIsCarriedOntoThatOfMH) {
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        const Case c = any(random);
        Probe h = c.probe.object;
        const glm::dvec3 p = h.point.xyz, u = h.tangents[0].xyz, v = h.tangents[1].xyz;
        h.polygon = {{p - u}, {p + u}, {p + v}};
        for (std::size_t k = 0; k < 2; ++k) h.tangents.at(k) = h.polygon[k + 1] - h.polygon[k];
        const ProbeInWorld probe = in_world(h, c.m);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto v_at = [&](DerivationLine line, double carried, const char* name) {
                const CarriedArrow arrow = named(carried_arrows({line, k, carried}, probe, c.m), name);
                EXPECT_TRUE(arrow.to_scale);
                return std::array{arrow.base, arrow.base + arrow.vector};
            };
            const auto is = [](const std::array<glm::dvec3, 2>& ends, const glm::dvec3& from, const glm::dvec3& to) {
                return glm::length(ends[0] - from) + glm::length(ends[1] - to) < 1e-9 * (1.0 + glm::length(to));
            };
            EXPECT_TRUE(is(v_at(DerivationLine::Given, 1.0, "v object"), h.polygon[k].xyz, h.polygon[k + 1].xyz));
            EXPECT_TRUE(is(v_at(DerivationLine::Tangent, 0.0, "M₃ v object"), h.polygon[k].xyz, h.polygon[k + 1].xyz));
            EXPECT_TRUE(
                is(v_at(DerivationLine::Tangent, 1.0, "M₃ v object"), probe.polygon[k].xyz, probe.polygon[k + 1].xyz));
            EXPECT_TRUE(is(v_at(DerivationLine::Rule, 1.0, "v world"), probe.polygon[k].xyz, probe.polygon[k + 1].xyz));
        }
    }
}

TEST(CarriedArrows, LinesAreTheDerivationsOwn) {
    Random random(1);
    const Case c = any(random);
    const Derivation d = derivation(c.m, 1, c.probe.object);
    ASSERT_EQ(d.steps.size(), kDerivationLines);
    const auto id = [&](DerivationLine line) { return d.steps[static_cast<std::size_t>(line)].id; };
    EXPECT_EQ(id(DerivationLine::Given), "given");
    EXPECT_EQ(id(DerivationLine::Wanted), "wanted");
    EXPECT_EQ(id(DerivationLine::Tangent), "tangent");
    EXPECT_EQ(id(DerivationLine::AsDotProduct), "as-dot-product");
    EXPECT_EQ(id(DerivationLine::SameDirection), "same-direction");
    EXPECT_EQ(id(DerivationLine::Rule), "rule");
}

TEST(CarriedArrows, ArriveWhereTheDerivationsNumbersAre) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Case c = any(random);
        const std::size_t tangent = i % 2 == 0 ? 0 : 1;
        const Derivation d = derivation(c.m, 1, c.probe.object, tangent);
        const auto of = [&](DerivationLine line) -> const Step& { return d.steps[static_cast<std::size_t>(line)]; };
        const auto shown = [&](DerivationLine line, double carried = 1.0) {
            return carried_arrows({line, tangent, carried}, c.probe, c.m);
        };
        const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
            return glm::length(a - b) < 1e-9 * (1.0 + glm::length(b));
        };
        const CarriedArrow v = named(shown(DerivationLine::Tangent), "M₃ v object");
        EXPECT_TRUE(near(v.vector, vec(*of(DerivationLine::Tangent).left().operands[1].value)));
        EXPECT_TRUE(near(v.base, c.probe.point.xyz));
        const CarriedArrow back = named(shown(DerivationLine::AsDotProduct), "M₃ᵀ n world");
        EXPECT_TRUE(near(back.vector, vec(*of(DerivationLine::SameDirection).left().value)));
        EXPECT_TRUE(near(back.vector, c.probe.object.normal.xyz));  // and lies on n_obj
        EXPECT_TRUE(near(back.base, c.probe.object.point.xyz));
        const CarriedArrow n = named(shown(DerivationLine::Rule), "(M₃⁻¹)ᵀ n object");
        EXPECT_TRUE(near(n.vector, vec(*d.n_world)));

        // On the way they begin where the line before had left them.
        EXPECT_TRUE(near(named(shown(DerivationLine::Tangent, 0.0), "M₃ v object").vector,
                         c.probe.object.tangents[tangent].xyz));
        EXPECT_TRUE(
            near(named(shown(DerivationLine::ProductOfTransposes, 0.0), "M₃ᵀ n world").vector, vec(*d.n_world)));
        EXPECT_FALSE(shown(DerivationLine::Tangent, 0.5).right_angle);
        for (int line = 0; line < static_cast<int>(kDerivationLines); ++line) {
            const CarriedArrows all = shown(static_cast<DerivationLine>(line));
            ASSERT_FALSE(all.arrows.empty());
            if (!all.right_angle) continue;
            const auto [a, b] = *all.right_angle;
            EXPECT_NEAR(*angle_degrees(all.arrows[a].vector, all.arrows[b].vector), 90.0, 1e-7) << line;
        }
    }
}

TEST(CarriedArrows, ATranslationMovesThePlaceAndNotTheVector) {
    const Transform<World, Object> m(product(std::vector<StackEntry>{Scale{{0.5, 2, 1}}, Translate{{3, 0, 0}}}));
    const ProbeInWorld probe = in_world(probe_with({{0.6, 0.8, 0}}, {{0.6, 0.8, 0}}), m);
    const auto carried = [&](double t) {
        return named(carried_arrows({DerivationLine::Tangent, 1, t}, probe, m), "M₃ v object");
    };
    for (const double t : {0.7, 0.8, 0.9}) {
        EXPECT_EQ(carried(t).vector, carried(1.0).vector);
        EXPECT_GT(glm::length(carried(t).base - carried(1.0).base), 0.2);
    }
    EXPECT_GT(glm::length(carried(0.3).vector - carried(1.0).vector), 0.1);
}

TEST(CarriedArrows, StandInThePictureInPlaceOfTheRules) {
    SurfaceCache surfaces;
    const Scene scene{.stack = {Scale{{0.5, 2, 1}}, Translate{{1, 0, 0}}}};
    const auto frame = [&](std::optional<DerivationAt> at) {
        return make_frame(scene, surfaces.get(scene),
                          {.rect = {{0, 0}, {640, 480}}, .marks = {.line = at, .highlight = {}, .labels = {}}});
    };
    EXPECT_FALSE(frame(std::nullopt).panes[0].arrows.empty());
    for (int line = 0; line < static_cast<int>(kDerivationLines); ++line) {
        const Frame shown = frame(DerivationAt{static_cast<DerivationLine>(line)});
        EXPECT_TRUE(shown.panes[0].arrows.empty());
        EXPECT_TRUE(std::ranges::any_of(shown.panes[0].labels, [](const Label& label) {
            return label.text.ends_with("object") || label.text.ends_with("world");
        }));
    }
}

TEST(CarriedArrows, NothingIsCarriedWhereThereIsNoNormal) {
    Random random(3);
    const Case c = any(random);
    const Transform<World, Object> flat(matrix(Scale{{1, 0, 1}}));
    EXPECT_TRUE(carried_arrows({}, in_world(c.probe.object, flat), flat).arrows.empty());
    // The picture is then as it is without the derivation.
    SurfaceCache surfaces;
    const Scene scene{.stack = {Scale{{1, 0, 1}}}};
    const Frame shown =
        make_frame(scene, surfaces.get(scene),
                   {.rect = {{0, 0}, {640, 480}}, .marks = {.line = DerivationAt{}, .highlight = {}, .labels = {}}});
    EXPECT_FALSE(shown.panes[0].arrows.empty());
}

}  // namespace
}  // namespace normalscope

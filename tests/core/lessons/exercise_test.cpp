#include "core/lessons/exercise.h"
#include "core/picture/make_frame.h"

#include "core/picture/exercise_arrow.h"
#include "core/surface/surface.h"
#include "random.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace normalscope {
namespace {

// The truth from tangents alone, without any inverse: what is perpendicular to both, on the side to which a point a
// little outside goes.
glm::dvec3 independent_truth(const Exercise& e) {
    const glm::dmat4 m = product(e.scene.stack);
    const glm::dvec3 n = e.normal.xyz, p = e.at.xyz;
    const glm::dvec3 t = glm::normalize(glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const auto image = [&](const glm::dvec3& v) { return glm::dvec3(m * glm::dvec4(v, 0.0)); };
    const glm::dvec3 across = glm::normalize(glm::cross(image(t), image(glm::cross(n, t))));
    const glm::dvec3 outside = glm::dvec3(m * glm::dvec4(p + 1e-3 * n, 1.0)) - glm::dvec3(m * glm::dvec4(p, 1.0));
    return glm::dot(across, outside) < 0.0 ? -across : across;
}

TEST(Exercise, TruthIsWhatTheTangentsSay) {
    std::array<int, kHardestLevel + 1> levels{};
    for (std::uint64_t seed = 0; seed < 60; ++seed)
        for (int number = 0; number < 24; ++number) {
            const Exercise e = make_exercise(seed, number);
            if (e.question) continue;
            ++levels[static_cast<std::size_t>(e.level)];
            EXPECT_LT(glm::length(e.truth.xyz - independent_truth(e)), 1e-9) << seed << ":" << number;
            EXPECT_NEAR(judge(e, {e.truth.xyz}, 0).degrees_off, 0.0, 1e-5);
            EXPECT_EQ(judge(e, {e.truth.xyz}, 0).points, 10);
            EXPECT_EQ(judge(e, {e.truth.xyz}, 2).points, 6);
            EXPECT_EQ(judge(e, {-e.truth.xyz}, 0).points, 0);
            EXPECT_FALSE(e.why.empty());
            EXPECT_EQ(e.hints.size(), 2u);
        }
    for (const int count : levels) EXPECT_GT(count, 10);
}

// An answer is worth the more, the better it is than the naive rule's; and the numbers shown are those judged by.
TEST(Exercise, PointsAreForWhatTheNaiveRuleGetsWrong) {
    for (std::uint64_t seed = 0; seed < 60; ++seed)
        for (int number = 0; number < 24; ++number) {
            const Exercise e = make_exercise(seed, number);
            if (e.question) continue;
            const Judgement naive = judge(e, {e.naive.xyz}, 0);
            if (naive.naive_off == 0.0) continue;
            EXPECT_GE(naive.naive_off, 15.0) << seed << ":" << number;
            EXPECT_EQ(naive.points, 0) << seed << ":" << number;
            if (naive.naive_off > 170.0) continue;
            const Judgement half = judge(e, {glm::normalize(e.naive.xyz + e.truth.xyz)}, 0);
            EXPECT_LE(half.points, 6) << seed << ":" << number;
            EXPECT_NEAR(half.degrees_off, naive.naive_off / 2, 0.11);
        }
}

TEST(Exercise, SaysWhoseErrorIsWhose) {
    Exercise e;
    e.truth = {{1, 0, 0}};
    e.naive = {{std::cos(0.44505), std::sin(0.44505), 0}};  // 25.5°
    e.why = "Because.";
    const auto at = [](double degrees) {
        const double a = degrees * std::acos(-1.0) / 180.0;
        return Vector<World>{{std::cos(a), std::sin(a), 0}};
    };
    EXPECT_EQ(verdict(e, judge(e, at(12.2), 0)),
              "Yours is 12.2° off the right one; the naive rule’s is 25.5°. Because.");
    EXPECT_EQ(points_line(judge(e, at(12.2), 1)),
              "3 of 10 points: all within 3° of the right one, none from 25.5° on, where the naive rule’s is; a hint "
              "costs 2.");
    EXPECT_EQ(judge(e, at(3.04), 0).points, 10);  // shown as 3.0°
    EXPECT_EQ(judge(e, at(3.1), 0).points, 9);
    EXPECT_TRUE(verdict(e, judge(e, at(2), 0)).starts_with("✓ Yours is 2.0° off"));
    e.naive = e.truth;
    EXPECT_TRUE(points_line(judge(e, at(9), 0))
                    .starts_with("5 of 10 points: all within 3° of the right one, none from 15° on; "));
}

TEST(Exercise, IsReproducible) {
    for (int number = 0; number < 30; ++number) {
        const Exercise a = make_exercise(42, number), b = make_exercise(42, number);
        EXPECT_EQ(a.scene, b.scene);
        EXPECT_EQ(a.task, b.task);
        EXPECT_EQ(a.truth, b.truth);
    }
    EXPECT_NE(make_exercise(1, 5).scene, make_exercise(2, 5).scene);
}

TEST(Exercise, QuestionsHaveOneRightChoiceAndReasons) {
    for (std::uint64_t seed = 0; seed < 60; ++seed)
        for (int number = 3; number < 40; number += 4) {
            const Exercise e = make_exercise(seed, number);
            ASSERT_TRUE(e.question);
            int right = 0;
            for (const Choice& choice : e.question->choices) {
                right += choice.right ? 1 : 0;
                EXPECT_FALSE(choice.because.empty());
            }
            EXPECT_EQ(right, 1);
        }
}

// The arrow can be dragged to the answer, wherever that is: then it is within what a pixel makes.
TEST(Exercise, TheAnswerCanBeDragged) {
    SurfaceCache surfaces;
    for (int number = 0; number < 24; ++number) {
        const Exercise e = make_exercise(7, number);
        if (e.question) continue;
        const Frame frame = make_frame(e.scene, surfaces.get(e.scene), {.rect = {{0, 0}, {1200, 800}}});
        ASSERT_TRUE(frame.probe);
        EXPECT_LT(glm::length(frame.probe->object.point.xyz - e.at.xyz), 0.01);
        ExerciseArrow best;
        double off = 180.0;
        for (int y = 0; y < 800; y += 4)
            for (int x = 0; x < 1200; x += 4) {
                ExerciseArrow arrow;
                arrow.drag_to(frame, e.scene.arrows.length, 1.0, {x, y});
                const double degrees = judge(e, arrow.direction, 0).degrees_off;
                if (degrees < off) off = degrees, best = arrow;
            }
        EXPECT_LT(off, 3.0) << number << ": " << e.task;
        EXPECT_NEAR(glm::length(best.direction.xyz), 1.0, 1e-9);
    }
}

}  // namespace
}  // namespace normalscope

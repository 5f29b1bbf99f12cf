#pragma once

#include "core/lessons/lesson.h"
#include "core/scene/scene.h"
#include "core/surface/probe.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// "Where does this normal go?": an M, a point of a surface with its normal, and the question where that points in the
/// world. Made anew from its seed and number, always the same, from easy to hard.
struct Exercise {
    std::uint64_t seed = 0;
    int number = 0;  ///< from 0
    int level = 0;   ///< 0 to 5

    Scene scene;  ///< what is seen before the answer
    Point<Object> at;
    Normal<Object> normal;  ///< unit, outward
    Normal<World> truth;    ///< unit, by the inverse transpose: outward in the world
    Normal<World> naive;    ///< unit

    std::string task;                ///< what M does
    std::vector<std::string> hints;  ///< from a nudge to nearly all
    std::string why;                 ///< one sentence

    /// Now and then a short question instead of an arrow.
    std::optional<Question> question;
};

inline constexpr int kHardestLevel = 5;

Exercise make_exercise(std::uint64_t seed, int number);

/// The scene with both arrows and their angle, once the answer is given.
Scene revealed(const Exercise& exercise);

inline constexpr int kMostPoints = 10;

/// How good an answer is. Angles in whole tenths of a degree, so that the points are those of the numbers shown.
struct Judgement {
    double degrees_off = 0.0, naive_off = 0.0;
    double none_from = 0.0;  ///< so many degrees off there are no points: no more than the naive rule is
    int points = 0;          ///< kMostPoints within 3°; each hint costs 2
};
Judgement judge(const Exercise& exercise, const Vector<World>& arrow, int hints);
/// What is said of it, and of its points.
std::string verdict(const Exercise& exercise, const Judgement& judgement);
std::string points_line(const Judgement& judgement);

/// "exercises", or "exercises:SEED": what opens them wherever a FILE is asked for. Empty for all else.
struct ExercisesName {
    std::optional<std::uint64_t> seed;
};
std::optional<ExercisesName> exercises_name(const std::string& file_or_name);

}  // namespace normalscope

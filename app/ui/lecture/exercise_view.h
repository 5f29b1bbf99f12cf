#pragma once

#include "core/lessons/exercise.h"
#include "core/picture/exercise_arrow.h"
#include "ui/lecture/caption_strip.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace normalscope {

/// "Where does this normal go?" in the window: one exercise after the other, each first tried, then seen.
class Exercises {
public:
    void start(std::uint64_t seed, Scene& scene);
    void stop() { running_ = false; }
    bool running() const { return running_; }
    std::uint64_t seed() const { return exercise_.seed; }
    /// The scene before the exercises, whose own have been stripped of what would tell the answer; else the scene itself.
    Scene scene_before(const Scene& scene) const;
    /// Ends the exercises, and gives that scene back.
    void leave(Scene& scene);

    /// The arrow that is to be dragged, in the picture.
    void add_to(Frame& frame, const Scene& scene, double pixel_scale) const;
    /// True where the press was on the arrow: what follows, until the release, turns it.
    bool grab(const Frame& frame, const Scene& scene, double pixel_scale, glm::dvec2 pixel);
    void drag(const Frame& frame, const Scene& scene, double pixel_scale, glm::dvec2 pixel);
    bool release() { return std::exchange(dragging_, false); }
    bool dragging() const { return dragging_; }
    void turn(const Frame& frame, double right, double up);
    const Vector<World>& arrow() const { return arrow_.direction; }

    /// One of some choices is to be made.
    bool asking() const { return running_ && exercise_.question && !answered(); }
    bool answered() const { return judgement_.has_value() || answer_.has_value(); }
    /// An arrow that nobody has moved is judged only when asked a second time: it may be the answer, or a slip of the key.
    void check(Scene& scene);
    void hint();
    void next(Scene& scene);
    void choose(std::size_t choice, Scene& scene);
    /// What is asked is answered: by the arrow as it is, or, of choices, by the right one, which nobody has guessed then.
    /// What has been answered is left for the next exercise.
    void go_on(Scene& scene);

    /// Something has been answered, which is lost with the exercises.
    bool has_score() const { return exercise_.number > 0 || answered(); }
    std::string score() const;  ///< "10 of 20 points"
    Speech speech() const;
    /// What may be said in this exercise, the present first: the strip holds any of them.
    std::vector<Speech> speeches() const;
    StripState state() const;
    /// What the strip's buttons ask for, but for its ×.
    void obey(const StripRequests& requests, Scene& scene);

private:
    bool can_turn() const { return running_ && !answered() && !exercise_.question; }
    void show(Scene& scene, const Scene& shown) const;
    void begin(int number, Scene& scene);

    bool running_ = false, dragging_ = false;
    Scene before_;
    Exercise exercise_;
    ExerciseArrow arrow_;
    bool moved_ = false, asked_unmoved_ = false;
    int hints_ = 0;
    std::optional<Judgement> judgement_;
    std::optional<std::size_t> answer_;
    int points_ = 0, possible_ = 0;
};

}  // namespace normalscope

#pragma once

#include "core/lessons/lesson.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// Goes through a lesson: which step is shown, the way from one to the next, and what has been answered. It edits the
/// scene as any other control does, so that a student may leave a step to play, and come back.
class LessonPlayer {
public:
    static constexpr double kSeconds = 0.9;  ///< from one step to the next

    /// What is shown at t from 0 to 1 of the way, which begins and ends gently. Where two scenes are possible and what lies
    /// between them is not, there is no way: it is `to` at once.
    static Scene between(const Scene& from, const Scene& to, double t);

    bool moves = true;  ///< false: a step is reached at once

    /// From the scene as it is to a step of the lesson.
    void start(std::shared_ptr<const Lesson> lesson, std::size_t step, const Scene& scene);
    /// Another version of the lesson, or another one: at this step, whose scene nothing moves to.
    void replace(std::shared_ptr<const Lesson> lesson, std::size_t step);
    void stop() { lesson_.reset(), way_.reset(); }
    bool running() const { return lesson_ != nullptr; }

    const Lesson& lesson() const { return *lesson_; }
    const std::shared_ptr<const Lesson>& shared_lesson() const { return lesson_; }
    std::size_t number() const { return step_; }  ///< counted from 0
    const LessonStep& step() const { return lesson_->steps[step_]; }
    bool has_next() const { return step_ + 1 < lesson_->steps.size(); }
    bool has_previous() const { return step_ > 0; }

    /// To another step, or to the same again: whatever the scene is now, the way begins there.
    void go_to(std::size_t step, const Scene& scene);

    /// On the way to the step.
    bool moving() const { return way_.has_value(); }
    /// Of which the last part is what the step itself shows, once.
    bool on_path() const { return way_ && way_->seconds >= kSeconds; }
    /// How much of the way is done, from 0 to 1, which begins and ends gently.
    double way_done() const;
    /// So many seconds further. Whoever changes the scene meanwhile stops the movement.
    void advance(double seconds, Scene& scene);
    /// Ends the movement at once.
    void arrive(Scene& scene);
    /// Whether the scene is no longer the step's. The theme does not count: it is the room's.
    bool strayed(const Scene& scene) const;

    /// The choice that was made last for this step's question.
    std::optional<std::size_t> answer() const {
        return answers_[step_] ? std::optional(answers_[step_]->choice) : std::nullopt;
    }
    void choose(std::size_t choice);
    /// This step has a question, and nothing has been chosen yet.
    bool asking() const { return step().question && !answer(); }
    /// Shows what is right, where nobody has chosen.
    void reveal();
    /// That is how the answer came about: it is nobody's.
    bool revealed() const { return answers_[step_] && answers_[step_]->revealed; }

private:
    struct Way {
        Scene from, shown;
        double seconds = 0.0;
    };
    struct Answer {
        std::size_t choice;
        bool revealed;
    };
    Scene target(const Scene& scene) const;
    void set_answer(const Answer& answer);

    std::shared_ptr<const Lesson> lesson_;
    std::size_t step_ = 0;
    std::optional<Way> way_;
    std::vector<std::optional<Answer>> answers_;
};

}  // namespace normalscope

#include "core/lessons/lesson_player.h"

#include "core/base/error.h"
#include "core/lessons/reading_time.h"
#include "core/scene/scene_blend.h"

#include <algorithm>

namespace normalscope {

namespace {
double gently(double t) { return t * t * (3.0 - 2.0 * t); }
}  // namespace

double LessonPlayer::way_done() const { return way_ ? gently(std::min(way_->seconds / kSeconds, 1.0)) : 1.0; }

Scene LessonPlayer::between(const Scene& from, const Scene& to, double t) {
    Scene scene = blend(from, to, gently(t));
    try {
        (void)world_from_object(scene);
    } catch (const InputError&) {
        return to;
    }
    return scene;
}

Scene LessonPlayer::target(const Scene& scene) const {
    Scene step_scene = step().scene;
    step_scene.theme = scene.theme;
    return step_scene;
}

void LessonPlayer::start(std::shared_ptr<const Lesson> lesson, std::size_t step, const Scene& scene) {
    lesson_ = std::move(lesson);
    answers_.assign(lesson_->steps.size(), std::nullopt);
    go_to(std::min(step, lesson_->steps.size() - 1), scene);
}

void LessonPlayer::replace(std::shared_ptr<const Lesson> lesson, std::size_t step) {
    lesson_ = std::move(lesson);
    answers_.resize(lesson_->steps.size());
    for (std::size_t i = 0; i < answers_.size(); ++i) {
        const std::optional<Question>& question = lesson_->steps[i].question;
        if (answers_[i] && (!question || answers_[i]->choice >= question->choices.size())) answers_[i].reset();
    }
    step_ = std::min(step, lesson_->steps.size() - 1);
    way_.reset();
}

void LessonPlayer::go_to(std::size_t step, const Scene& scene) {
    if (!running() || step >= lesson_->steps.size()) return;
    step_ = step;
    way_ = Way{scene, scene, 0.0};
}

void LessonPlayer::advance(double seconds, Scene& scene) {
    if (!way_) return;
    if (!(scene == way_->shown)) {
        way_.reset();
        return;
    }
    way_->seconds += seconds;
    const Scene end = target(scene);
    const std::vector<ScenePath>& paths = step().paths;
    const double all = kSeconds + (paths.empty() ? 0.0 : ScenePath::kSeconds);
    if (!moves || way_->seconds >= all) return arrive(scene);
    Scene next = way_->seconds < kSeconds
                     ? between(way_->from, normalscope::on_path(end, paths, 0.0), way_->seconds / kSeconds)
                     : normalscope::on_path(end, paths, (way_->seconds - kSeconds) / ScenePath::kSeconds);
    if (paths.empty() && next == end) return arrive(scene);
    scene = way_->shown = std::move(next);
}

void LessonPlayer::arrive(Scene& scene) {
    if (!way_) return;
    scene = target(scene);
    way_.reset();
}

bool LessonPlayer::strayed(const Scene& scene) const { return running() && !moving() && !(scene == target(scene)); }

void LessonPlayer::choose(std::size_t choice) { set_answer({choice, false}); }

void LessonPlayer::reveal() {
    if (running() && asking()) set_answer({right_choice(*step().question), true});
}

void LessonPlayer::set_answer(const Answer& answer) {
    if (running() && step().question && answer.choice < step().question->choices.size()) answers_[step_] = answer;
}

}  // namespace normalscope

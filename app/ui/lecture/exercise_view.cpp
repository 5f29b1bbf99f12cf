#include "ui/lecture/exercise_view.h"

#include "core/lessons/reading_time.h"

#include <algorithm>
#include <utility>

namespace normalscope {

namespace {

constexpr const char* kUnmoved =
    "You have not moved the arrow yet: it still points as the normal does on the object. Check (Enter) again to answer "
    "with it.";

std::string task_of(const Exercise& exercise) {
    return exercise.question ? exercise.task : exercise.task + " Drag the dark arrow to where the normal points.";
}

}  // namespace

void Exercises::start(std::uint64_t seed, Scene& scene) {
    before_ = scene_before(scene);
    running_ = true;
    points_ = possible_ = 0;
    exercise_.seed = seed;
    begin(0, scene);
}

Scene Exercises::scene_before(const Scene& scene) const {
    if (!running_) return scene;
    Scene before = before_;
    before.theme = scene.theme;  // the room's light
    return before;
}

void Exercises::leave(Scene& scene) {
    scene = scene_before(scene);
    stop();
}

void Exercises::begin(int number, Scene& scene) {
    exercise_ = make_exercise(exercise_.seed, number);
    judgement_.reset();
    answer_.reset();
    hints_ = 0;
    dragging_ = moved_ = asked_unmoved_ = false;
    arrow_.direction = {exercise_.normal.xyz};  // as it is in the object: what people start from
    show(scene, exercise_.scene);
}

// The room's light, and how somebody likes to look at it, stay.
void Exercises::show(Scene& scene, const Scene& shown) const {
    const Theme theme = scene.theme;
    scene = shown;
    scene.theme = theme;
}

void Exercises::add_to(Frame& frame, const Scene& scene, double pixel_scale) const {
    if (!running_ || exercise_.question) return;
    arrow_.add_to(frame, scene.arrows.length, pixel_scale, answered() ? "yours" : "drag");
    add_object_in_front(frame, pixel_scale);
}

bool Exercises::grab(const Frame& frame, const Scene& scene, double pixel_scale, glm::dvec2 pixel) {
    return dragging_ = can_turn() && arrow_.near(frame, scene.arrows.length, pixel_scale, pixel);
}

void Exercises::drag(const Frame& frame, const Scene& scene, double pixel_scale, glm::dvec2 pixel) {
    if (!dragging_) return;
    moved_ = true;
    arrow_.drag_to(frame, scene.arrows.length, pixel_scale, pixel);
}

void Exercises::turn(const Frame& frame, double right, double up) {
    if (!can_turn()) return;
    moved_ = true;
    arrow_.turn(frame, right, up);
}

void Exercises::check(Scene& scene) {
    if (!can_turn()) return;
    if (!moved_ && !std::exchange(asked_unmoved_, true)) return;
    judgement_ = judge(exercise_, arrow_.direction, hints_);
    points_ += judgement_->points;
    possible_ += kMostPoints;
    const Camera camera = scene.camera;
    show(scene, revealed(exercise_));
    scene.camera = camera;
}

void Exercises::hint() {
    if (!can_turn()) return;
    hints_ = std::min(hints_ + 1, static_cast<int>(exercise_.hints.size()));
    asked_unmoved_ = false;
}

void Exercises::next(Scene& scene) {
    if (answered()) begin(exercise_.number + 1, scene);
}

void Exercises::choose(std::size_t choice, Scene& scene) {
    if (!exercise_.question || choice >= exercise_.question->choices.size()) return;
    if (!answer_) {  // the first one counts; the others may be looked at
        possible_ += kMostPoints;
        points_ += exercise_.question->choices[choice].right ? kMostPoints : 0;
        show(scene, revealed(exercise_));
    }
    answer_ = choice;
}

void Exercises::go_on(Scene& scene) {
    if (answered()) return next(scene);
    if (!asking()) return check(scene);
    choose(right_choice(*exercise_.question), scene);
    points_ -= kMostPoints;
}

Speech Exercises::speech() const {
    Speech speech{task_of(exercise_), {}, {}, exercise_.question};
    if (judgement_) {
        speech.caption = verdict(exercise_, *judgement_);
        speech.look_at = points_line(*judgement_);
    } else if (asked_unmoved_ && !moved_)
        speech.look_at = kUnmoved;
    else if (hints_ > 0)
        speech.look_at = exercise_.hints[static_cast<std::size_t>(hints_ - 1)];
    else if (!exercise_.question)
        speech.look_at = "Grey: the normal on the object. Arrow keys turn yours, too; Enter checks.";
    return speech;
}

std::vector<Speech> Exercises::speeches() const {
    std::vector<Speech> all{speech()};
    if (exercise_.question) return all;
    for (const std::string& hint : exercise_.hints) all.push_back({task_of(exercise_), hint, {}, {}});
    const Judgement naive = judge(exercise_, {exercise_.naive.xyz}, 0);
    all.push_back({task_of(exercise_), kUnmoved, {}, {}});
    all.push_back({verdict(exercise_, naive), points_line(naive), {}, {}});
    return all;
}

std::string Exercises::score() const {
    return std::to_string(points_) + " of " + std::to_string(possible_) + " points";
}

StripState Exercises::state() const {
    StripState state;
    const std::string number = std::to_string(exercise_.number + 1);
    // What matters first: in a narrow column its end is cut off.
    state.title = "Exercise " + number + "   " + score() + "   set " + std::to_string(exercise_.seed);
    state.short_title = "Exercise " + number;
    if (possible_ > 0) state.short_title += ": " + std::to_string(points_) + " of " + std::to_string(possible_);
    state.answer = answer_;
    state.closes = true;
    if (answered())
        state.actions = {{"Next", "The next exercise (Page Down, Enter)", true}};
    else if (!exercise_.question)
        state.actions = {{"Check", "Shows the right normal, and the naive one (Enter)", true},
                         {"Hint", "Each costs 2 of 10 points (?)", hints_ < static_cast<int>(exercise_.hints.size())}};
    return state;
}

void Exercises::obey(const StripRequests& requests, Scene& scene) {
    if (requests.choose) choose(*requests.choose, scene);
    if (!requests.action) return;
    if (answered())
        next(scene);
    else if (*requests.action == 0)
        check(scene);
    else
        hint();
}

}  // namespace normalscope

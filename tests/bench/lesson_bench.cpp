// What a lecturer waits for, drawn off-screen as the window draws it: from a lesson's name to its first step's picture, and
// the frames on the way from step to step, with the panel and in presenter mode. Prints one line of JSON, by lesson, or
// for the lesson that is named.

#include "bench_gui.h"
#include "core/frame/display_scale.h"
#include "core/frame/frame.h"
#include "core/lessons/lesson.h"
#include "core/lessons/lesson_player.h"
#include "core/picture/make_frame.h"
#include "core/surface/level_sets.h"
#include "core/surface/surface.h"
#include "measure.h"
#include "platform/offscreen_context.h"
#include "viewer/opening.h"
#include "viewer/pace.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

using namespace normalscope;

namespace {

constexpr glm::ivec2 kSize(1280, 720);
constexpr int kFramesBetweenSteps = 12;

class Window {
public:
    explicit Window(bool presenting) : scale_(DisplayScale{}.of(1.0f, kSize, presenting)) {
        gui_.interface().lecture().present(presenting);
    }

    void open(const std::string& lesson) {
        Opened opened = open_file(lesson, scene_);
        surfaces_ = std::move(opened.surfaces);
        lesson_ = opened.lesson;
        gui_.interface().open_lesson(std::move(opened.lesson), scene_, 0);
        scene_ = lesson_->steps.front().scene;
    }
    void draw(const Scene& scene, std::size_t step, bool moving) {
        const Stopwatch watch;
        if (step != step_) gui_.interface().open_lesson(lesson_, scene, step_ = step);
        const std::shared_ptr<const Surface> surface = surfaces_->get(scene);
        const Frame frame = make_frame(scene, surface,
                                       {.rect = gui_.interface().picture(kSize),
                                        .pixel_scale = scale_,
                                        .handles = true,
                                        .quality = moving ? Quality::Draft : Quality::Fine,
                                        .level_sets = level_sets_.get(scene, surface->implicit)});
        Status status;
        const Transform<World, Object> m = world_from_object(scene);
        if (const auto naive = normal_map(scene, m, Rule::Naive))
            status.errors = error_statistics(surface->mesh, *naive, m);
        Scene shown = scene;
        gui_.layout(scene.theme, scale_, [&] { gui_.interface().draw(shown, frame, status); });
        const bool rough = pace_.rough(moving) || (moving && surface->implicit);
        gui_.draw({frame, true, rough, pace_.coarse(), true});
        pace_.took(watch.seconds());
    }

    const Lesson& lesson() const { return *lesson_; }

private:
    float scale_;
    Pace pace_;
    BenchGui gui_{kSize};
    std::unique_ptr<SurfaceCache> surfaces_;
    LevelSetsCache level_sets_;
    Scene scene_;
    std::shared_ptr<const Lesson> lesson_;
    std::size_t step_ = 0;
};

struct Took {
    double opening = 0.0;       // until the picture is there
    std::vector<double> steps;  // a frame's median, on the way to each
};

Took measure(const std::string& lesson, bool presenting) {
    Window window(presenting);  // the one before is gone: there is just one Dear ImGui
    Took took;
    std::vector<double> openings;
    for (int i = 0; i < 6; ++i) {
        const Stopwatch watch;
        window.open(lesson);
        window.draw(window.lesson().steps.front().scene, 0, false);
        if (i > 0) openings.push_back(watch.milliseconds());  // the first one compiles shaders
    }
    took.opening = median(openings);
    const std::vector<LessonStep>& steps = window.lesson().steps;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        std::vector<double> frames;
        window.draw(steps[i - 1].scene, i - 1, false);
        for (int k = -1; k < kFramesBetweenSteps; ++k) {
            const Scene scene = LessonPlayer::between(steps[i - 1].scene, steps[i].scene,
                                                      (std::max(k, 0) + 1.0) / (kFramesBetweenSteps + 1.0));
            const Stopwatch watch;
            window.draw(scene, i, true);
            if (k >= 0) frames.push_back(watch.milliseconds());  // the one before compiles and builds what is new
        }
        took.steps.push_back(median(frames));
    }
    return took;
}

void print(const char* name, const std::vector<double>& values) {
    std::printf(", \"%s\": [", name);
    for (std::size_t i = 0; i < values.size(); ++i) std::printf("%s%.1f", i == 0 ? "" : ", ", values[i]);
    std::printf("]");
}

}  // namespace

int main(int count, char** arguments) {
    const auto context = make_offscreen_context({});
    context->make_current();
    std::printf("{");
    bool first = true;
    for (const ListedLesson& lesson : built_in_lessons()) {
        if (count > 1 && lesson.name != arguments[1]) continue;
        const Took plain = measure(lesson.name, false);
        std::printf("%s\"%s\": {\"opening_ms\": %.1f", first ? "" : ", ", lesson.name.c_str(), plain.opening);
        print("frame_ms", plain.steps);
        print("presenting_frame_ms", measure(lesson.name, true).steps);
        std::printf("}");
        first = false;
    }
    std::printf("}\n");
}

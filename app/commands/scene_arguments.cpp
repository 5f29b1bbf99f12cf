#include "commands/scene_arguments.h"

#include "core/base/error.h"
#include "core/lessons/open.h"
#include "core/scene/setting.h"
#include "ui/lecture/marks_of_step.h"

namespace normalscope {

Subject subject_of(const std::string& file, const std::vector<std::string>& settings) {
    const Contents contents = open_name(file);
    Subject subject{first_scene(contents), {}};
    for (const std::string& setting : settings) subject.scene = with_setting(subject.scene, setting);
    if (const auto* opened = std::get_if<OpenedLesson>(&contents); opened && opened->step) {
        subject.lesson = opened->lesson;
        subject.step = *opened->step;
    }
    return subject;
}

CaptureOptions capture_options(const PictureArguments& arguments, const Subject& subject) {
    if (arguments.captions && !subject.lesson)
        throw UsageError("--captions: FILE must be a lesson's step, such as 1-normal-as-a-point#3");
    return {.size = arguments.size,
            .samples = arguments.samples,
            .ground = arguments.ground,
            .scale = arguments.scale,
            .panel = arguments.panel || !arguments.tab.empty(),
            .tab = arguments.tab,
            .lesson = arguments.captions ? subject.lesson : nullptr,
            .step = subject.step,
            .marks = subject.lesson ? marks_of(subject.lesson->steps[subject.step]) : StepMarks()};
}

}  // namespace normalscope

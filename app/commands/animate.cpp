#include "commands/commands.h"

#include "batch/cancel.h"
#include "batch/numbered.h"
#include "batch/progress.h"
#include "batch/video.h"
#include "commands/files_of_run.h"
#include "commands/studio.h"
#include "core/base/error.h"
#include "core/base/output.h"
#include "core/base/temporary_folder.h"
#include "core/image/png.h"
#include "core/lessons/lesson_player.h"
#include "core/lessons/open.h"
#include "platform/crash_line.h"

#include <cmath>
#include <cstdio>
#include <optional>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

struct Picture {
    Scene scene;
    std::size_t step = 0;
    bool same = false;  ///< as the one before
};

std::vector<Picture> pictures_of(const Lesson& lesson, int frames_per_second, double seconds) {
    std::vector<Picture> pictures;
    const auto moving = static_cast<int>(std::lround(LessonPlayer::kSeconds * frames_per_second)),
               still = std::max(static_cast<int>(std::lround(seconds * frames_per_second)), 1);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const Scene& here = lesson.steps[i].scene;
        for (int k = 1; i > 0 && k < moving; ++k) {
            const double t = static_cast<double>(k) / moving;
            pictures.push_back({LessonPlayer::between(lesson.steps[i - 1].scene, here, t), i});
        }
        for (int k = 0; k < still; ++k) pictures.push_back({here, i, k > 0});
    }
    return pictures;
}

// A picture that is held takes no more room.
bool linked(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::create_hard_link(from, to, error);
    return !error;
}

}  // namespace

int run(const AnimateCommand& command) {
    const bool video = is_video(command.output);
    if (video) require_ffmpeg(command.output);
    const auto lesson = std::make_shared<const Lesson>(load_lesson(command.lesson));
    const std::vector<Picture> pictures = pictures_of(*lesson, command.frames_per_second, command.seconds);

    const auto named = [&](std::size_t i) { return video ? fs::path(command.output) : numbered(command.output, i); };
    FilesOfRun files;
    for (const LessonStep& step : lesson->steps) files.reads_scene(command.lesson, step.scene);
    for (std::size_t i = 0; i < (video ? 1 : pictures.size()); ++i)
        files.writes(named(i), "--output " + named(i).string());

    std::optional<TemporaryFolder> frames;
    if (video) frames.emplace(command.output);
    const auto file = [&](std::size_t i) { return video ? frames->path() / numbered("%06d.png", i) : named(i); };
    if (const fs::path folder = file(0).parent_path(); !folder.empty()) {
        std::error_code ignored;  // writing will say what is wrong
        fs::create_directories(folder, ignored);
    }
    const CrashLine crash_line;
    Studio studio({.context = command.context, .pictures = pictures.size()});
    const CancelOnSignal cancel;
    {
        Progress progress(pictures.size());
        Image image;
        for (std::size_t i = 0; i < pictures.size() && !CancelOnSignal::asked(); ++i) {
            const Picture& picture = pictures[i];
            if (!picture.same)
                image =
                    studio.capture(picture.scene, {.size = command.size, .lesson = lesson, .step = picture.step}).image;
            if (!video)
                write_png(file(i), image);
            else if (!picture.same || !linked(file(i - 1), file(i)))
                write_frame(file(i), image, command.output);
            progress.step();
        }
    }
    if (CancelOnSignal::asked() ||
        (video && !write_video(frames->path(), pictures.size(), command.frames_per_second, command.output))) {
        std::fprintf(stderr, "normalscope: cancelled; %s\n",
                     video ? "no video was written" : "the pictures that were written are whole");
        return CancelOnSignal::exit_code();
    }
    print(std::to_string(pictures.size()) + " pictures: " + command.output + "\n");
    return 0;
}

}  // namespace normalscope

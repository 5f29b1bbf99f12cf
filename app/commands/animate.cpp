#include "commands/commands.h"

#include "batch/cancel.h"
#include "batch/numbered.h"
#include "batch/progress.h"
#include "batch/video.h"
#include "commands/files_of_run.h"
#include "commands/studio.h"
#include "commands/subtitles.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/math_text.h"
#include "core/base/output.h"
#include "core/base/output_names.h"
#include "core/base/temporary_folder.h"
#include "core/image/png.h"
#include "core/lessons/lesson_player.h"
#include "core/lessons/open.h"
#include "core/lessons/reading_time.h"
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
    std::optional<std::size_t> answer;  ///< that has been given
    bool same = false;                  ///< as the one before
};

/// A lesson, picture by picture: on the way to a step, at the step, and at its answer.
struct Film {
    std::vector<Picture> pictures;
    Subtitles subtitles;
};

Film film_of(const Lesson& lesson, int frames_per_second, const std::optional<double>& seconds) {
    Film film;
    const auto pictures_in = [&](double time) { return static_cast<int>(std::lround(time * frames_per_second)); };
    // Subtitles go by what is shown, in whole pictures.
    const auto hold = [&](const Picture& picture, double time, const std::string& words) {
        const int count = std::max(pictures_in(time), 1);
        film.pictures.insert(film.pictures.end(), static_cast<std::size_t>(count), picture);
        for (auto k = film.pictures.end() - count + 1; k != film.pictures.end(); ++k) k->same = true;
        film.subtitles.say(plain_math(words), static_cast<double>(count) / frames_per_second);
    };
    const int moving = pictures_in(LessonPlayer::kSeconds);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        const Scene begins = on_path(step.scene, step.paths, 0.0);
        for (int k = 1; i > 0 && k < moving; ++k) {
            const double t = static_cast<double>(k) / moving;
            film.pictures.push_back({.scene = LessonPlayer::between(lesson.steps[i - 1].scene, begins, t), .step = i});
            film.subtitles.pause(1.0 / frames_per_second);
        }
        const int moved = step.paths.empty() ? 0 : pictures_in(ScenePath::kSeconds);
        for (int k = 0; k < moved; ++k)
            film.pictures.push_back(
                {.scene = on_path(step.scene, step.paths, static_cast<double>(k) / moved), .step = i});
        film.subtitles.pause(static_cast<double>(moved) / frames_per_second);
        hold({.scene = step.scene, .step = i}, seconds.value_or(seconds_of(step)),
             step.caption + (step.question ? " " + step.question->text : ""));
        if (!step.question) continue;
        const std::size_t right = right_choice(*step.question);
        const Choice& choice = step.question->choices[right];
        hold({.scene = step.scene, .step = i, .answer = right}, seconds.value_or(seconds_of_answer(*step.question)),
             choice.text + (std::string_view(".?!").find(choice.text.back()) == std::string_view::npos ? ". " : " ") +
                 choice.because);
    }
    return film;
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
    const Film film = film_of(*lesson, command.frames_per_second, command.seconds);
    const std::vector<Picture>& pictures = film.pictures;

    const auto named = [&](std::size_t i) { return video ? fs::path(command.output) : numbered(command.output, i); };
    FilesOfRun files;
    for (const LessonStep& step : lesson->steps) files.reads_scene(command.lesson, step.scene);
    for (std::size_t i = 0; i < (video ? 1 : pictures.size()); ++i)
        files.writes(named(i), "--output " + named(i).string());
    if (command.subtitles) files.writes(*command.subtitles, "--subtitles " + command.subtitles->string());

    const CancelOnSignal cancel;  // before anything is made that it would have to take away
    std::optional<TemporaryFolder> frames;
    if (video) frames.emplace(command.output);
    const auto file = [&](std::size_t i) { return video ? frames->path() / numbered("%06d.png", i) : named(i); };
    if (!video) make_folders(command.output, pictures.size());
    const CrashLine crash_line;
    Studio studio({.context = command.context, .pictures = pictures.size()});
    {
        Progress progress(pictures.size());
        Image image;
        for (std::size_t i = 0; i < pictures.size() && !CancelOnSignal::asked(); ++i) {
            const Picture& picture = pictures[i];
            if (!picture.same)
                image =
                    studio
                        .capture(
                            picture.scene,
                            {.size = command.size, .lesson = lesson, .step = picture.step, .answer = picture.answer})
                        .image;
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
    if (command.subtitles) write_file(*command.subtitles, film.subtitles.text(*command.subtitles));
    print(pictures_written(command.output, pictures.size()) + "\n");
    return 0;
}

}  // namespace normalscope

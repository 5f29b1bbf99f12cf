#include "commands/commands.h"

#include "batch/batch.h"
#include "batch/cancel.h"
#include "batch/numbered.h"
#include "batch/progress.h"
#include "batch/video.h"
#include "commands/contact_sheet.h"
#include "commands/scene_arguments.h"
#include "commands/studio.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/temporary_folder.h"
#include "core/image/png.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <optional>

namespace normalscope {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The pictures of a sweep in their order: of two things that vary, the second one goes on from picture to picture, as
/// along the rows of a table.
class Plan {
public:
    explicit Plan(const std::vector<Variation>& variations) : variations_(variations) {}

    std::size_t columns() const { return variations_.back().values.size(); }
    std::size_t count() const {
        std::size_t product = 1;
        for (const Variation& v : variations_) product *= v.values.size();
        return product;
    }
    std::vector<std::string> settings(std::size_t i) const {
        if (variations_.size() == 1) return {variations_[0].setting(i)};
        return {variations_[0].setting(i / columns()), variations_[1].setting(i % columns())};
    }

private:
    const std::vector<Variation>& variations_;
};

Scene varied(const Scene& base, const std::vector<std::string>& settings) {
    try {
        return with_settings(base, settings);
    } catch (const InputError& e) {
        std::string line = e.what();  // it was not given as --set
        if (line.starts_with("--set ")) line.replace(2, 3, "vary");
        throw InputError(line);
    }
}

// How many columns make a sheet of `count` pictures about as wide as they are themselves.
std::size_t near_square(std::size_t count) {
    std::size_t columns = 1;
    while (columns * columns < count) ++columns;
    return columns;
}

}  // namespace

int run(const SweepCommand& command) {
    const Plan plan(command.variations);
    const bool video = is_video(command.output);
    if (video) require_ffmpeg(command.output);
    std::vector<Scene> scenes;
    const Scene base = scene_for(command.file, command.settings);
    for (std::size_t i = 0; i < plan.count(); ++i) scenes.push_back(varied(base, plan.settings(i)));

    std::optional<TemporaryFolder> frames;
    if (video) frames.emplace(command.output);
    const std::string pattern = video ? (frames->path() / "%06d.png").string() : command.output;
    const auto file = [&](std::size_t i) { return numbered(pattern, i, plan.columns()); };
    if (const fs::path folder = file(0).parent_path(); !folder.empty()) {
        std::error_code ignored;  // writing will say what is wrong
        fs::create_directories(folder, ignored);
    }

    std::vector<std::string> numbers(command.numbers ? plan.count() : 0);
    const CancelOnSignal cancel;
    {
        std::optional<Progress> progress(std::in_place, plan.count());
        std::size_t drawn = 0;
        const bool whole =
            run_batch({.count = plan.count(),
                       .jobs = command.jobs,
                       .start =
                           [&] {
                               auto studio = std::make_shared<Studio>(
                                   command.context, plan.count() / static_cast<std::size_t>(command.jobs));
                               return [&, studio](std::size_t i) -> Finish {
                                   auto capture = std::make_shared<Capture>(studio->capture(
                                       scenes[i], capture_options(command, command.numbers.has_value())));
                                   return [&, i, capture] {
                                       if (video)
                                           write_frame(file(i), capture->image, command.output);
                                       else
                                           write_png(file(i), capture->image);
                                       return std::move(capture->numbers);
                                   };
                               };
                           },
                       .done =
                           [&](std::size_t i, std::string text) {
                               if (command.numbers) numbers[i] = std::move(text);
                               ++drawn;
                               progress->step();
                           }});
        progress.reset();
        if (!whole || CancelOnSignal::asked()) {
            std::fprintf(stderr, "normalscope: cancelled after %zu of %zu pictures; %s\n", drawn, plan.count(),
                         video ? "no video was written" : "those that were written are whole");
            return CancelOnSignal::exit_code();
        }
    }

    if (command.sheet)
        write_png(
            *command.sheet,
            contact_sheet(plan.count(), command.variations.size() == 2 ? plan.columns() : near_square(plan.count()),
                          [&](std::size_t i) { return read_png(file(i)); }));
    if (command.numbers) {
        Json all = Json::array();
        for (std::size_t i = 0; i < plan.count(); ++i) {
            Json entry{{"set", plan.settings(i)}};
            entry.update(Json::parse(numbers[i]));
            all.push_back(std::move(entry));
        }
        write_file(*command.numbers, json_text(all) + "\n");
    }
    if (video && !write_video(frames->path(), plan.count(), command.frames_per_second, command.output)) {
        std::fprintf(stderr, "normalscope: cancelled; no video was written\n");
        return CancelOnSignal::exit_code();
    }
    if (command.numbers != "/dev/stdout") {
        const std::string count = std::to_string(plan.count()) + " pictures: ";
        write_file(
            "/dev/stdout",
            count + (video ? command.output : file(0).string() + " to " + file(plan.count() - 1).string()) + "\n");
    }
    return 0;
}

}  // namespace normalscope

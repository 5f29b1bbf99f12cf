#include "commands/commands.h"

#include "batch/batch.h"
#include "batch/cancel.h"
#include "batch/jobs.h"
#include "batch/numbered.h"
#include "batch/progress.h"
#include "batch/video.h"
#include "commands/contact_sheet.h"
#include "commands/files_of_run.h"
#include "commands/scene_arguments.h"
#include "commands/studio.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_path.h"
#include "core/base/json_text.h"
#include "core/base/output.h"
#include "core/base/output_names.h"
#include "core/base/temporary_folder.h"
#include "core/base/utf8.h"
#include "core/image/png.h"
#include "core/mesh/mesh_file.h"
#include "core/picture/framing.h"
#include "platform/crash_line.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <set>

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
    std::vector<Setting> settings(std::size_t i) const {
        if (variations_.size() == 1) return {variations_[0].setting(i)};
        return {variations_[0].setting(i / columns()), variations_[1].setting(i % columns())};
    }

private:
    const std::vector<Variation>& variations_;
};

Scene varied(Scene scene, const std::vector<Setting>& settings) {
    try {
        for (const Setting& setting : settings) scene = with_setting(scene, setting);
        return scene;
    } catch (const JsonError& e) {
        throw UsageError("--vary " + std::string(e.what()));
    }
}

Json texts_of(const std::vector<Setting>& settings) {
    Json texts = Json::array();
    for (const Setting& setting : settings) texts.push_back(setting.text());
    return texts;
}

// How many columns make a sheet of `count` pictures about as wide as they are themselves.
std::size_t near_square(std::size_t count) {
    std::size_t columns = 1;
    while (columns * columns < count) ++columns;
    return columns;
}

/// A sweep on its way: what is drawn, where it goes, and what has been found.
struct Sweep {
    const SweepCommand& command;
    Plan plan{command.variations};
    bool video = is_video(command.output);
    std::vector<Scene> scenes{};
    CaptureOptions options{};
    std::string pattern = command.output;  ///< of the pictures' names; a video's lie in a folder for the time being
    fs::path frames{};                     ///< that folder
    std::vector<Capture> captures{};       ///< without their images

    fs::path file(std::size_t i) const {
        return video && frames.empty() ? fs::path(command.output) : numbered(pattern, i, plan.columns());
    }
};

void refuse_to_overwrite(const Sweep& sweep, const Scene& base) {
    FilesOfRun files;
    files.reads_scene(sweep.command.file, base);
    for (std::size_t i = 0; i < (sweep.video ? 1 : sweep.plan.count()); ++i) {
        const fs::path file = sweep.video ? fs::path(sweep.command.output) : sweep.file(i);
        files.writes(file, "--output " + file.string());
    }
    if (sweep.command.sheet) files.writes(*sweep.command.sheet, "--sheet");
    if (sweep.command.numbers) files.writes(*sweep.command.numbers, "--numbers");
}

Finish draw(const Sweep& sweep, Studio& studio, std::size_t i) {
    auto capture = std::make_shared<Capture>(studio.capture(sweep.scenes[i], sweep.options));
    return [&sweep, i, capture] {
        if (sweep.video)
            write_frame(sweep.file(i), capture->image, sweep.command.output);
        else
            write_png(sweep.file(i), capture->image);
        return Json::array({std::move(capture->numbers), std::move(capture->notes)}).dump();
    };
}

// False where it was cancelled, which it says.
bool draw_all(Sweep& sweep) {
    const SweepCommand& command = sweep.command;
    const std::size_t count = sweep.plan.count(), jobs = std::min(static_cast<std::size_t>(command.jobs), count);
    sweep.captures.resize(count);
    std::size_t drawn = 0;
    std::optional<Progress> progress(std::in_place, count);
    const bool whole = run_batch(
        {.count = count,
         .jobs = jobs,
         .word = sweep.frames.string(),
         .start =
             [&] {
                 auto studio = std::make_shared<Studio>(StudioOptions{command.context, count / jobs, jobs});
                 return [&, studio](std::size_t i) { return draw(sweep, *studio, i); };
             },
         .done =
             [&](std::size_t i, const std::string& text) {
                 Json told = Json::parse(text);
                 sweep.captures[i] = {{}, told[0].get<std::string>(), told[1].get<std::vector<std::string>>()};
                 ++drawn;
                 progress->step();
             }});
    progress.reset();
    if (whole && !CancelOnSignal::asked()) return true;
    std::fprintf(stderr, "normalscope: cancelled after %zu of %zu pictures; %s\n", drawn, count,
                 sweep.video ? "no video was written" : "those that were written are whole");
    return false;
}

void write_sheet(const Sweep& sweep) {
    const Plan& plan = sweep.plan;
    const std::size_t columns = sweep.command.variations.size() == 2 ? plan.columns() : near_square(plan.count());
    const Image sheet = contact_sheet(plan.count(), columns, [&](std::size_t i) { return read_png(sweep.file(i)); });
    write(*sweep.command.sheet, png_bytes(sheet));
}

void write_numbers(const Sweep& sweep) {
    Json all = Json::array();
    for (std::size_t i = 0; i < sweep.plan.count(); ++i) {
        Json entry{{"set", texts_of(sweep.plan.settings(i))}};
        entry.update(Json::parse(sweep.captures[i].numbers));
        all.push_back(std::move(entry));
    }
    write(*sweep.command.numbers, json_text(all) + "\n");
}

// Each note once, with the first picture that it is of. How many there were.
std::size_t print_notes(const Sweep& sweep) {
    std::set<std::string> notes;
    for (std::size_t i = 0; i < sweep.captures.size(); ++i)
        for (const std::string& note : sweep.captures[i].notes)
            if (notes.insert(note).second)
                std::fprintf(stderr, "normalscope: %s: %s\n", sweep.plan.settings(i).front().text().c_str(),
                             in_one_line(note).c_str());
    return notes.size();
}

}  // namespace

int run(const SweepCommand& command) {
    Sweep sweep{.command = command};
    if (sweep.video) require_ffmpeg(command.output);
    Subject base = subject_of(command.file, command.settings);
    if (const auto* mesh = std::get_if<MeshSurface>(&base.scene.surface); mesh && gives_once(mesh->mesh))
        throw InputError(mesh->mesh,
                         "is not a regular file, and a sweep reads its mesh several times; save it to a file first");
    // As the first sees it, lest what grows always fill the picture.
    if (!base.scene.camera.zoom) base.scene = with_zoom(base.scene, *SurfaceCache().get(base.scene));
    const std::size_t count = sweep.plan.count();
    for (std::size_t i = 0; i < count; ++i) sweep.scenes.push_back(varied(base.scene, sweep.plan.settings(i)));
    sweep.options = capture_options(command, base);
    sweep.options.numbers = command.numbers.has_value();
    refuse_to_overwrite(sweep, base.scene);

    const CancelOnSignal cancel;  // before anything is made that it would have to take away
    std::optional<TemporaryFolder> frames;
    if (sweep.video) {
        sweep.frames = word_for_jobs().value_or("");  // made by the process that started this one
        if (sweep.frames.empty()) sweep.frames = frames.emplace(command.output).path();
        sweep.pattern = literally(sweep.frames.string()) + "/%06d.png";
    }
    make_folders(sweep.pattern, count, sweep.plan.columns());
    std::optional<CrashLine> crash_line;
    if (command.jobs == 1) crash_line.emplace();  // of other processes run_jobs tells
    if (!draw_all(sweep)) return CancelOnSignal::exit_code();
    const int noted = print_notes(sweep) > 0 && command.fail_on_note ? 1 : 0;
    if (command.sheet) write_sheet(sweep);
    if (command.numbers) write_numbers(sweep);
    if (sweep.video && !write_video(sweep.frames, count, command.frames_per_second, command.output)) {
        std::fprintf(stderr, "normalscope: cancelled; no video was written\n");
        return CancelOnSignal::exit_code();
    }
    if (!command.numbers || !command.numbers->is_standard())
        print(pictures_written(command.output, count, sweep.plan.columns()) + "\n");
    return noted;
}

}  // namespace normalscope

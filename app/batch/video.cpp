#include "batch/video.h"

#include "batch/cancel.h"
#include "batch/other_program.h"
#include "batch/progress.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/system.h"
#include "core/base/text.h"
#include "core/image/png.h"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

bool is_full(const fs::path& folder) {
    std::error_code unknown;
    const fs::space_info space = fs::space(folder, unknown);
    return !unknown && space.available < std::uintmax_t{1} << 14;
}

// Half as many pixels of colour as of brightness is all that most players show; hence even sides.
std::vector<std::string> format_options(const fs::path& video) {
    std::vector<std::string> options{
        "-vf",      "pad=ceil(iw/2)*2:ceil(ih/2)*2",
        "-pix_fmt", "yuv420p",
        "-fflags",  "+bitexact",  // no random number, date or version: the same bytes each time
        "-flags:v", "+bitexact"};
    if (has_ending(video.string(), ".webm"))
        options.insert(options.end(), {"-crf", "24", "-b:v", "0", "-f", "webm"});
    else
        options.insert(options.end(), {"-movflags", "+faststart", "-f", "mp4"});
    return options;
}

/// How many pictures ffmpeg says it has taken, in a file to which it adds its lines: "frame=12".
class Taken {
public:
    explicit Taken(const fs::path& file) : lines_(file) {}
    std::size_t now() {
        lines_.clear();
        for (std::string line; std::getline(lines_, line);)
            if (line.starts_with("frame=")) taken_ = std::strtoul(line.c_str() + 6, nullptr, 10);
        return taken_;
    }

private:
    std::ifstream lines_;
    std::size_t taken_ = 0;
};

// Its exit status, or nothing where it was cancelled; what it writes goes to `log`.
std::optional<int> run(std::vector<std::string> command, const fs::path& log, Progress& progress) {
    const fs::path report = fs::path(log).replace_extension("progress");
    write_file(report, "");  // so that it can be opened before there is anything in it
    command.insert(command.begin() + 1, {"-nostats", "-progress", report.string()});
    Taken taken(report);
    OtherProgram ffmpeg(command, log);
    while (!CancelOnSignal::asked()) {
        if (const auto status = ffmpeg.ended_within(20)) return status;
        progress.reach(taken.now());
    }
    return std::nullopt;
}

}  // namespace

void require_ffmpeg(const fs::path& video) {
    if (!find_program("ffmpeg"))
        throw InputError(video.string() + ": needs ffmpeg, which is not installed; " + remedy(Missing::Ffmpeg) +
                         ", or write single pictures: -o frame-%03d.png");
}

void write_frame(const fs::path& file, const Image& image, const fs::path& video) {
    try {
        write_png(file, image);
    } catch (const InputError& e) {
        throw InputError(video.string(), e.reason);
    }
}

bool write_video(const fs::path& frames, std::size_t pictures, int frames_per_second, const fs::path& video) {
    // From the root, since ffmpeg takes -x for an option and x: for a protocol.
    const fs::path folder = fs::absolute(frames), log = folder / "ffmpeg.log",
                   partial = folder / ("video" + video.extension().string());
    std::vector<std::string> start{find_program("ffmpeg").value_or("ffmpeg").string(),
                                   "-y",
                                   "-xerror",  // or a disk that fills at the very end leaves half a video, and no error
                                   "-loglevel",
                                   "error",
                                   "-framerate",
                                   std::to_string(frames_per_second),
                                   "-i",
                                   (folder / "%06d.png").string()};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> command = start;
        command.insert(command.end(), more.begin(), more.end());
        return command;
    };
    std::vector<std::vector<std::string>> commands;
    if (has_ending(video.string(), ".gif")) {
        // A palette of the video's own colours, or all 256 go to a colour cube. It is found first: a single command for
        // both keeps all pictures in memory.
        const std::string palette = (folder / "palette.png").string();
        commands.push_back(with({"-vf", "palettegen=stats_mode=diff", "-update", "1", palette}));
        commands.push_back(
            with({"-i", palette, "-lavfi", "paletteuse=dither=sierra2_4a", "-f", "gif", partial.string()}));
    } else {
        commands.push_back(with(format_options(video)));
        commands.back().push_back(partial.string());
    }
    Progress progress(pictures, "pictures in the video");
    for (const std::vector<std::string>& command : commands) {
        const std::optional<int> status = run(command, log, progress);
        if (!status) return false;
        if (*status == 0) continue;
        std::string said = read_file(log, std::size_t{1} << 20);
        while (said.ends_with('\n') || said.ends_with('\r')) said.pop_back();
        if (is_full(folder)) said = "\nNo space left on device";  // ffmpeg's own words have found no room either
        throw InputError(video.string() + ": ffmpeg could not make it: " + said.substr(said.rfind('\n') + 1));
    }
    try {
        replace_file(partial, video);
    } catch (const std::system_error& e) {
        throw InputError(video.string() + ": cannot be written: " + e.code().message());
    }
    return true;
}

}  // namespace normalscope

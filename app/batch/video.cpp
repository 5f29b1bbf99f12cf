#include "batch/video.h"

#include "batch/cancel.h"
#include "batch/progress.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/image/png.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

std::optional<fs::path> find_ffmpeg() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        fs::path program = fs::path(folder) / "ffmpeg";
        if (::access(program.c_str(), X_OK) == 0) return program;
    }
    return std::nullopt;
}

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
    if (video.extension() == ".webm")
        options.insert(options.end(), {"-crf", "24", "-b:v", "0", "-f", "webm"});
    else
        options.insert(options.end(), {"-movflags", "+faststart", "-f", "mp4"});
    return options;
}

pid_t start(const std::vector<std::string>& command, const fs::path& log) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
        ::setpgid(0, 0);  // Ctrl+C goes to this program alone, which then ends the other one
        const int nothing = ::open("/dev/null", O_RDONLY),
                  out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (nothing < 0 || out < 0) ::_exit(127);
        ::dup2(nothing, STDIN_FILENO);
        ::dup2(out, STDOUT_FILENO);
        ::dup2(out, STDERR_FILENO);
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    return process;
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
    const pid_t process = start(command, log);
    if (process < 0) return -1;
    int status = 0;
    for (;;) {
        const pid_t ended = ::waitpid(process, &status, WNOHANG);
        if (ended == process) break;
        if (ended < 0 && errno != EINTR) return -1;
        if (CancelOnSignal::asked()) {
            ::kill(process, SIGKILL);
            ::waitpid(process, &status, 0);
            return std::nullopt;
        }
        progress.reach(taken.now());
        ::poll(nullptr, 0, 20);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

bool is_video(const fs::path& file) {
    const fs::path ending = file.extension();
    return ending == ".gif" || ending == ".mp4" || ending == ".webm";
}

void require_ffmpeg(const fs::path& video) {
    if (!find_ffmpeg())
        throw InputError(video.string() +
                         ": needs ffmpeg, which is not installed; install the package ffmpeg, or write "
                         "single pictures: -o frame-%03d.png");
}

void write_frame(const fs::path& file, const Image& image, const fs::path& video) {
    try {
        write_png(file, image);
    } catch (const InputError& e) {
        throw InputError(video.string(), e.reason);
    }
}

bool write_video(const fs::path& folder, std::size_t pictures, int frames_per_second, const fs::path& video) {
    const fs::path log = folder / "ffmpeg.log", partial = folder / ("video" + video.extension().string());
    std::vector<std::string> start{find_ffmpeg().value_or("ffmpeg").string(),
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
    if (video.extension() == ".gif") {
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
        while (said.ends_with('\n')) said.pop_back();
        if (is_full(folder)) said = "\nNo space left on device";  // ffmpeg's own words have found no room either
        throw InputError(video.string() + ": ffmpeg could not make it: " + said.substr(said.rfind('\n') + 1));
    }
    std::error_code error;
    fs::rename(partial, video, error);
    if (error) throw InputError(video.string() + ": cannot be written: " + error.message());
    return true;
}

}  // namespace normalscope

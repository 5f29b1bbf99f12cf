#include "video.h"

#include "core/error.h"
#include "core/file.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
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
        const fs::path program = fs::path(folder) / "ffmpeg";
        if (::access(program.c_str(), X_OK) == 0) return program;
    }
    return std::nullopt;
}

std::vector<std::string> format_options(const fs::path& video) {
    if (video.extension() == ".gif")  // a palette of the video's own colours, or all 256 go to a colour cube
        return {"-vf", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=sierra2_4a", "-f", "gif"};
    // Half as many pixels of colour as of brightness is all that most players show; hence even sides.
    std::vector<std::string> options{"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
    if (video.extension() == ".webm")
        options.insert(options.end(), {"-crf", "24", "-b:v", "0", "-f", "webm"});
    else
        options.insert(options.end(), {"-movflags", "+faststart", "-f", "mp4"});
    return options;
}

// Its exit status; what it writes goes to `log`.
int run(const std::vector<std::string>& command, const fs::path& log) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
        const int nothing = ::open("/dev/null", O_RDONLY),
                  out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(nothing, STDIN_FILENO);
        ::dup2(out, STDOUT_FILENO);
        ::dup2(out, STDERR_FILENO);
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    int status = -1;
    while (process > 0 && ::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return process > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
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

void write_video(const fs::path& folder, int frames_per_second, const fs::path& video) {
    const fs::path log = folder / "ffmpeg.log", partial = folder / ("video" + video.extension().string());
    std::vector<std::string> command{find_ffmpeg().value_or("ffmpeg").string(),
                                     "-y",
                                     "-loglevel",
                                     "error",
                                     "-framerate",
                                     std::to_string(frames_per_second),
                                     "-i",
                                     (folder / "%06d.png").string()};
    const std::vector<std::string> format = format_options(video);
    command.insert(command.end(), format.begin(), format.end());
    command.push_back(partial.string());
    if (run(command, log) != 0) {
        std::string said = read_file(log, std::size_t{1} << 20);
        while (said.ends_with('\n')) said.pop_back();
        throw InputError(video.string() + ": ffmpeg could not make it: " + said.substr(said.rfind('\n') + 1));
    }
    std::error_code error;
    fs::rename(partial, video, error);
    if (error) throw InputError(video.string() + ": cannot be written: " + error.message());
}

}  // namespace normalscope

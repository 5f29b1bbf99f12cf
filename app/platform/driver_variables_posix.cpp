#include "platform/driver_variables.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>  // environ

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>

namespace normalscope {

namespace {

constexpr std::array<std::string_view, 7> kOfMesa{"GALLIUM_", "GALLIVM_", "LP_", "MESA_", "LIBGL_", "DRAW_", "EGL_"};

// What continuous integration sets, as the README has it; every other value costs the time of a first picture.
constexpr std::array<std::string_view, 4> kHarmless{"GALLIUM_DRIVER=llvmpipe", "GALLIUM_DRIVER=softpipe",
                                                    "LP_NATIVE_VECTOR_WIDTH=128", "LIBGL_ALWAYS_SOFTWARE=1"};

bool is_doubtful(std::string_view variable) {
    const auto begins = [&](std::string_view with) { return variable.starts_with(with); };
    return std::ranges::any_of(kOfMesa, begins) && !variable.ends_with('=') &&
           std::ranges::find(kHarmless, variable) == kHarmless.end() && !begins("LP_NUM_THREADS=") &&
           !begins("MESA_SHADER_CACHE_");
}

std::string doubtful_driver_variables() {
    std::string line;
    for (char** variable = environ; variable && *variable; ++variable)
        if (is_doubtful(*variable)) line += (line.empty() ? "" : ", ") + std::string(*variable);
    return line;
}

// Whether a process of its own gets through the attempt without crashing; what it throws does not count. It says nothing
// on standard error.
bool survives(const std::function<void()>& attempt) {
    const pid_t process = ::fork();
    if (process < 0) return true;  // then the attempt itself has to tell
    if (process == 0) {
        const rlimit no_core{0, 0};
        ::setrlimit(RLIMIT_CORE, &no_core);
        if (const int nothing = ::open("/dev/null", O_WRONLY); nothing >= 0) ::dup2(nothing, STDERR_FILENO);
        try {
            attempt();
        } catch (...) {  // it will be thrown, and reported, once more
        }
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string crashing_driver_variables(const std::function<void()>& attempt) {
    std::string doubtful = doubtful_driver_variables();
    return doubtful.empty() || survives(attempt) ? "" : doubtful;
}

}  // namespace normalscope

#include "platform/driver_variables.h"

#include <unistd.h>  // environ

#include <algorithm>
#include <array>
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

}  // namespace

std::string doubtful_driver_variables() {
    std::string line;
    for (char** variable = environ; variable && *variable; ++variable)
        if (is_doubtful(*variable)) line += (line.empty() ? "" : ", ") + std::string(*variable);
    return line;
}

}  // namespace normalscope

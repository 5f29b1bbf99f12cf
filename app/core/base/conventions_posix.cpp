#include "core/base/system.h"

namespace normalscope {

std::filesystem::path program_file() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

std::filesystem::path settings_folder_of(const char* program) {
    const std::filesystem::path config = variable("XDG_CONFIG_HOME"), home = home_folder();
    if (config.is_absolute()) return config / program;
    return home.is_absolute() ? home / ".config" / program : std::filesystem::path();
}

std::filesystem::path data_folder_of(const char* program) {
    const std::filesystem::path data = variable("XDG_DATA_HOME"), home = home_folder();
    if (data.is_absolute()) return data / program;
    return home.is_absolute() ? home / ".local" / "share" / program : std::filesystem::path();
}

const char* remedy(Missing what) {
    switch (what) {
        case Missing::Osmesa: return "install libosmesa6";
        case Missing::Egl: return "install libegl1 with libgl1-mesa-dri";
        case Missing::OpenGl:
            return "OpenGL 3.3 is needed, which remote desktops and virtual machines may lack: install the graphics "
                   "card's driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw without one";
        case Missing::Ffmpeg: return "install the package ffmpeg";
    }
    return "";
}

}  // namespace normalscope

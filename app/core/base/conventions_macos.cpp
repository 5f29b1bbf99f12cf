#include "core/base/system.h"

#include <array>
#include <cstdint>

// Of <mach-o/dyld.h>, which is on a Mac alone, while this file is looked at elsewhere, too.
extern "C" int _NSGetExecutablePath(char* path, std::uint32_t* size);  // NOLINT(bugprone-reserved-identifier)

namespace normalscope {

// A link to the program within its bundle is followed.
std::filesystem::path program_file() {
    std::array<char, 4096> path{};
    auto size = static_cast<std::uint32_t>(path.size());
    if (::_NSGetExecutablePath(path.data(), &size) != 0) return {};
    std::error_code none;
    return std::filesystem::canonical(path.data(), none);
}

std::filesystem::path settings_folder_of(const char* program) {
    const std::filesystem::path home = home_folder();
    return home.is_absolute() ? home / "Library/Application Support" / program : std::filesystem::path();
}

std::filesystem::path data_folder_of(const char* program) { return settings_folder_of(program); }

const char* remedy(Missing what) {
    switch (what) {
        case Missing::Osmesa:
        case Missing::Egl: return "a Mac has none; leave --context out";
        case Missing::OpenGl: return "OpenGL 3.3 is needed, which virtual machines and remote sessions may lack";
        case Missing::Ffmpeg: return "install ffmpeg, and put it into a folder of PATH";
    }
    return "";
}

}  // namespace normalscope

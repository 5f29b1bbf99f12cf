#include "core/base/system.h"

#include <windows.h>

#include <string>

namespace normalscope {

std::filesystem::path program_file() {
    constexpr std::size_t kLongestPath = 32768;
    std::wstring path(kLongestPath, L'\0');
    path.resize(::GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
    return path;
}

std::filesystem::path settings_folder_of(const char* program) {
    const std::filesystem::path folder = variable("APPDATA");
    return folder.is_absolute() ? folder / program : std::filesystem::path();
}

std::filesystem::path data_folder_of(const char* program) { return settings_folder_of(program); }

const char* remedy(Missing what) {
    switch (what) {
        case Missing::Osmesa: return "put Mesa's osmesa.dll beside normalscope.exe";
        case Missing::Egl: return "Windows has none; leave --context out";
        case Missing::OpenGl:
            return "OpenGL 3.3 is needed, which remote desktops and virtual machines may lack: install the graphics "
                   "card's driver, or put Mesa's opengl32.dll beside normalscope.exe";
        case Missing::Ffmpeg: return "put ffmpeg.exe into a folder of PATH";
    }
    return "";
}

}  // namespace normalscope

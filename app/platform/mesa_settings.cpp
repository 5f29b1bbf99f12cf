#include "platform/mesa_settings.h"

#include "core/base/system.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace normalscope {

SetForNow::SetForNow(const char* name, const std::string& value, Unless unless) {
    const char* const given = std::getenv(name);
    if (given && unless == Unless::UsersOwn) return;
    if (given) before_ = given;
    name_ = name;
    set_variable(name, value);
}

SetForNow::~SetForNow() {
    if (name_) set_variable(name_, before_);
}

namespace {

constexpr const char *kFolder = "MESA_SHADER_CACHE_DIR", *kDisable = "MESA_SHADER_CACHE_DISABLE";

// Where Mesa would look; empty where that is not known.
std::filesystem::path usual_folder() {
    for (const char* name : {kFolder, "XDG_CACHE_HOME"})
        if (const std::string given = variable(name); !given.empty()) return given;
    const std::filesystem::path home = home_folder();
    return home.empty() ? home : home / ".cache";
}

}  // namespace

ShadersByWidth::ShadersByWidth() {
    const std::string width = variable("LP_NATIVE_VECTOR_WIDTH");
    const bool is_number = !width.empty() && width.find_first_not_of("0123456789") == width.npos;
    const std::filesystem::path usual = usual_folder();
    if (!is_number || !variable(kDisable).empty()) return;
    const std::filesystem::path folder = usual / "normalscope" / ("shaders-" + width);
    std::error_code error;
    if (!usual.empty()) std::filesystem::create_directories(folder, error);
    // Mesa would look elsewhere for a folder that can be used, and there find code for any width.
    if (usual.empty() || error)
        setting_.emplace(kDisable, "true");
    else
        setting_.emplace(kFolder, folder.string(), SetForNow::Unless::Never);
}

}  // namespace normalscope

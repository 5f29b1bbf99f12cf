#include "platform/shader_cache.h"

#include "core/base/system.h"

#include <filesystem>
#include <system_error>
#include <utility>

namespace normalscope {

namespace {

constexpr const char* kFolder = "MESA_SHADER_CACHE_DIR";

// Where Mesa would look; empty where that is not known.
std::filesystem::path usual_folder() {
    for (const char* name : {kFolder, "XDG_CACHE_HOME"})
        if (const std::string given = variable(name); !given.empty()) return given;
    const std::filesystem::path home = home_folder();
    return home.empty() ? home : home / ".cache";
}

}  // namespace

ShaderCacheByWidth::ShaderCacheByWidth() {
    const std::string width = variable("LP_NATIVE_VECTOR_WIDTH");
    const bool is_number = !width.empty() && width.find_first_not_of("0123456789") == width.npos;
    const std::filesystem::path usual = usual_folder();
    if (!is_number || usual.empty() || !variable("MESA_SHADER_CACHE_DISABLE").empty()) return;
    const std::filesystem::path folder = usual / "normalscope" / ("shaders-" + width);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return;
    if (std::string given = variable(kFolder); !given.empty()) given_ = std::move(given);
    set_variable(kFolder, folder.string());
    set_ = true;
}

ShaderCacheByWidth::~ShaderCacheByWidth() {
    if (set_) set_variable(kFolder, given_);
}

}  // namespace normalscope

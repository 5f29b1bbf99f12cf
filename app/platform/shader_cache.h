#pragma once

#include <optional>
#include <string>

namespace normalscope {

/// Mesa keeps compiled shaders, but takes code for one LP_NATIVE_VECTOR_WIDTH for that of another (22.3): made for 256 bits it
/// writes beyond the room that there is with 128. While one of these lives, Mesa is told a folder of the width's own, where one
/// is set; it asks for it once, when a process makes its first context.
class ShaderCacheByWidth {
public:
    ShaderCacheByWidth();
    ~ShaderCacheByWidth();
    ShaderCacheByWidth(const ShaderCacheByWidth&) = delete;
    ShaderCacheByWidth& operator=(const ShaderCacheByWidth&) = delete;

private:
    bool set_ = false;
    std::optional<std::string> given_;
};

}  // namespace normalscope

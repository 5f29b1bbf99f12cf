#pragma once

#include <optional>
#include <string>

namespace normalscope {

/// A variable of the environment while one lives: Mesa can be told some things in no other way, and reads them once, when a
/// process makes its first context. Nothing that is started later must find them.
class SetForNow {
public:
    enum class Unless { UsersOwn, Never };
    SetForNow(const char* name, const std::string& value, Unless unless = Unless::UsersOwn);
    ~SetForNow();
    SetForNow(const SetForNow&) = delete;
    SetForNow& operator=(const SetForNow&) = delete;

private:
    const char* name_ = nullptr;  // none: left as it is
    std::optional<std::string> before_;
};

/// Mesa keeps compiled shaders, but takes code for one LP_NATIVE_VECTOR_WIDTH for that of another (22.3): made for 256 bits it
/// writes beyond the room that there is with 128. So where a width is set, its code has a folder of its own, or is not kept.
class ShadersByWidth {
public:
    ShadersByWidth();

private:
    std::optional<SetForNow> setting_;
};

}  // namespace normalscope

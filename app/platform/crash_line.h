#pragma once

#include <string_view>

namespace normalscope {

/// While one lives, a crash is one line on standard error, and the exit code of a driver that cannot draw: Mesa crashes
/// where it finds no memory. Not under NORMALSCOPE_GL_DEBUG, which is for looking into faults, nor where somebody listens
/// for crashes already, as a sanitizer does.
class CrashLine {
public:
    CrashLine();
    ~CrashLine();
    CrashLine(const CrashLine&) = delete;
    CrashLine& operator=(const CrashLine&) = delete;

    static constexpr std::string_view kLine =
        "normalscope: crashed while drawing, most likely in the graphics driver; is there enough memory?\n";
    static constexpr int kExitCode = 4;

private:
    bool listening_ = false;
};

}  // namespace normalscope

#pragma once

#include <array>

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

private:
    std::array<char, 1 << 16> stack_;  ///< the other one may be what has overflowed
    bool listening_ = false;
};

}  // namespace normalscope

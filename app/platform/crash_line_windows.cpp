#include "platform/crash_line.h"

#include <windows.h>

#include <csignal>
#include <cstdlib>

namespace normalscope {

namespace {

// Only what a thread that has crashed may do.
[[noreturn]] void say_so() {
    DWORD written = 0;
    ::WriteFile(::GetStdHandle(STD_ERROR_HANDLE), CrashLine::kLine.data(), static_cast<DWORD>(CrashLine::kLine.size()),
                &written, nullptr);
    ::TerminateProcess(::GetCurrentProcess(), CrashLine::kExitCode);
    std::abort();
}

LONG WINAPI on_crash(EXCEPTION_POINTERS*) { say_so(); }
void on_abort(int) { say_so(); }

}  // namespace

CrashLine::CrashLine() {
    if (std::getenv("NORMALSCOPE_GL_DEBUG")) return;
    listening_ = true;
    ::SetUnhandledExceptionFilter(on_crash);
    std::signal(SIGABRT, on_abort);
}

CrashLine::~CrashLine() {
    if (!listening_) return;
    ::SetUnhandledExceptionFilter(nullptr);
    std::signal(SIGABRT, SIG_DFL);
}

}  // namespace normalscope

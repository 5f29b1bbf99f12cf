#include "platform/crash_line.h"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace normalscope {

namespace {

constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE};

// Only what a signal's handler may do.
void say_so(int) {
    constexpr std::string_view kLine =
        "normalscope: crashed while drawing, most likely in the graphics driver; is there enough memory?\n";
    (void)!::write(STDERR_FILENO, kLine.data(), kLine.size());
    ::_exit(4);
}

}  // namespace

CrashLine::CrashLine() {
    struct sigaction found{};
    if (std::getenv("NORMALSCOPE_GL_DEBUG") || ::sigaction(SIGSEGV, nullptr, &found) != 0 ||
        found.sa_handler != SIG_DFL)
        return;
    listening_ = true;
    const stack_t stack{.ss_sp = stack_.data(), .ss_flags = 0, .ss_size = stack_.size()};
    ::sigaltstack(&stack, nullptr);
    struct sigaction action{};
    action.sa_handler = say_so;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
    for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
}

CrashLine::~CrashLine() {
    if (!listening_) return;
    for (const int signal : kSignals) ::signal(signal, SIG_DFL);
    const stack_t none{.ss_sp = nullptr, .ss_flags = SS_DISABLE, .ss_size = 0};
    ::sigaltstack(&none, nullptr);
}

}  // namespace normalscope

#include "platform/crash_line.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace normalscope {

namespace {

std::array<char, 1 << 16> own_stack;  // the other one may be what has overflowed

constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE};

// Only what a signal's handler may do.
void say_so(int) {
    (void)!::write(STDERR_FILENO, CrashLine::kLine.data(), CrashLine::kLine.size());
    ::_exit(CrashLine::kExitCode);
}

}  // namespace

CrashLine::CrashLine() {
    struct sigaction found{};
    if (std::getenv("NORMALSCOPE_GL_DEBUG") || ::sigaction(SIGSEGV, nullptr, &found) != 0 ||
        found.sa_handler != SIG_DFL)
        return;
    listening_ = true;
    const stack_t stack{.ss_sp = own_stack.data(), .ss_flags = 0, .ss_size = own_stack.size()};
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

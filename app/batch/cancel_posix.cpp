#include "batch/cancel.h"

#include <csignal>
#include <initializer_list>

namespace normalscope {

namespace {

volatile std::sig_atomic_t caught = 0;

void on_signal(int number) { caught = number; }

void handle(void (*handler)(int), int flags) {
    struct sigaction action{};
    action.sa_handler = handler;
    action.sa_flags = flags;
    for (const int number : {SIGINT, SIGTERM}) ::sigaction(number, &action, nullptr);
}

}  // namespace

// SA_RESTART: a write that a signal interrupts goes on.
CancelOnSignal::CancelOnSignal() {
    handle(on_signal, static_cast<int>(SA_RESTART | SA_RESETHAND));
    std::signal(SIGPIPE, SIG_IGN);
}
CancelOnSignal::~CancelOnSignal() {
    handle(SIG_DFL, 0);
    std::signal(SIGPIPE, SIG_DFL);
}

bool CancelOnSignal::asked() { return caught != 0; }
int CancelOnSignal::exit_code() { return 128 + caught; }

}  // namespace normalscope

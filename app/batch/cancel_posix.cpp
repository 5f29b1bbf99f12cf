#include "batch/cancel.h"

#include <array>
#include <csignal>

namespace normalscope {

namespace {

volatile std::sig_atomic_t caught = 0;

void on_signal(int number) { caught = number; }

struct Signal {
    int number;
    struct sigaction before{};
};
std::array signals{Signal{SIGINT}, Signal{SIGTERM}, Signal{SIGHUP}};

}  // namespace

// SA_RESTART: a write that a signal interrupts goes on. What nohup, or a shell for what runs in the background, has made the
// program deaf to, it stays deaf to.
CancelOnSignal::CancelOnSignal() {
    struct sigaction action{};
    action.sa_handler = on_signal;
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    for (Signal& signal : signals) {
        ::sigaction(signal.number, nullptr, &signal.before);
        if (signal.before.sa_handler != SIG_IGN) ::sigaction(signal.number, &action, nullptr);
    }
    std::signal(SIGPIPE, SIG_IGN);
}
CancelOnSignal::~CancelOnSignal() {
    for (const Signal& signal : signals) ::sigaction(signal.number, &signal.before, nullptr);
    std::signal(SIGPIPE, SIG_DFL);
}

bool CancelOnSignal::asked() { return caught != 0; }
int CancelOnSignal::exit_code() { return 128 + caught; }

}  // namespace normalscope

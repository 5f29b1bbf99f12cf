#include "batch/cancel.h"

#include <csignal>
#include <initializer_list>

namespace normalscope {

namespace {

volatile std::sig_atomic_t caught = 0;

// By now the next one ends the program.
void on_signal(int number) { caught = number; }

void handle(void (*handler)(int)) {
    for (const int number : {SIGINT, SIGTERM, SIGBREAK}) std::signal(number, handler);
}

}  // namespace

CancelOnSignal::CancelOnSignal() { handle(on_signal); }
CancelOnSignal::~CancelOnSignal() { handle(SIG_DFL); }

bool CancelOnSignal::asked() { return caught != 0; }
int CancelOnSignal::exit_code() { return 128 + caught; }

}  // namespace normalscope

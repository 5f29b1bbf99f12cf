#pragma once

namespace normalscope {

/// While one lives, the first Ctrl+C (or SIGTERM, or SIGHUP of a terminal that is closed) ends nothing by itself: whoever
/// works asks `asked` between two pictures, and leaves whole files behind. A second one ends the program at once. And where
/// nobody reads standard output any more, that is an error of writing, and ends nothing.
class CancelOnSignal {
public:
    CancelOnSignal();
    ~CancelOnSignal();
    CancelOnSignal(const CancelOnSignal&) = delete;
    CancelOnSignal& operator=(const CancelOnSignal&) = delete;

    static bool asked();
    /// As shells have it: 130 for Ctrl+C.
    static int exit_code();
};

}  // namespace normalscope

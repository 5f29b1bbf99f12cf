#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace normalscope {

/// What is left to be done for a picture once it is drawn, such as encoding it; it runs in another thread, and gives the
/// text that `done` is told.
using Finish = std::function<std::string()>;

/// Many pictures by one or more processes, each of which draws with a context of its own.
struct Batch {
    std::size_t count = 0;
    std::size_t jobs = 1;
    /// Never draw in this process, which then outlives a driver that crashes.
    bool apart = false;
    std::string word = {};  ///< that each process may ask for: see run_jobs
    /// Called once in each process; gives what draws picture i, for any of 0 … count − 1.
    std::function<std::function<Finish(std::size_t i)>()> start;
    /// Called in this process alone, one call at a time, in the order in which the pictures are finished.
    std::function<void(std::size_t i, std::string text)> done;
};

/// False where it was cancelled (see CancelOnSignal); what was done until then is whole. Throws what `start`, drawing and
/// finishing throw, and InputError where a process ends early; `done` has been told all that was finished before.
bool run_batch(const Batch& batch);

}  // namespace normalscope

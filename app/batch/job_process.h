#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

/// A process that does one of run_jobs' jobs, as the one that started it sees it.
struct JobProcess {
    std::intptr_t process = -1;
    std::intptr_t stop_sign = -1;  ///< Windows: an event
    int pipe = -1;                 ///< what the job says comes out of here; -1 once it has ended

    /// Waits for its end. How it died; empty where it ended well.
    std::string end();
    /// Asks it to end once it has drawn what it is at: CancelOnSignal's `asked` there.
    void stop() const;
};

/// Where a job is to be done, and what there is to know.
struct JobSeat {
    std::size_t job = 0;
    int pipe = -1;  ///< to write into
    std::string word;
};

/// Starts one: the program anew, with the same arguments, which comes to run_jobs and finds its seat there. Nothing where
/// there can be no more.
std::optional<JobProcess> start_job(std::size_t job, const std::string& word);
/// The seat of this process, where it has been started anew to do a job.
const std::optional<JobSeat>& own_seat();

/// Until one of them has said something, or has ended; for 200 ms at most. Which of them, in their order.
std::vector<bool> wait_for_any(std::span<const JobProcess> jobs);

}  // namespace normalscope

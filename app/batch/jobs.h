#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace normalscope {

using Tell = std::function<void(std::size_t i, std::string text)>;

/// Runs `work(job, tell)` in one process for each job of 0 … count − 1; what they tell reaches `told` in this process.
/// Rethrows what a job throws, once all have ended; InputError where one ends without a word. Call it before anything
/// starts a thread.
void run_jobs(std::size_t count, const std::function<void(std::size_t job, const Tell& tell)>& work, const Tell& told);

}  // namespace normalscope

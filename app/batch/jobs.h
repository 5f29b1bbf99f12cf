#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace normalscope {

using Tell = std::function<void(std::size_t i, std::string text)>;
using Work = std::function<void(std::size_t job, const Tell& tell)>;

/// Runs `work(job, tell)` in one process for each job of 0 … count − 1; what they tell reaches `told` in this process.
/// Rethrows what a job throws, once all have ended; InputError where one ends without a word. Each of them is the program
/// started anew, with the same arguments: in those it does not return, and whatever comes before must come to the same there.
/// `word`, a line, is what they could not know otherwise.
void run_jobs(std::size_t count, const Work& work, const Tell& told, const std::string& word);

/// In a process that has been started anew to do a job: `word`.
std::optional<std::string> word_for_jobs();

}  // namespace normalscope

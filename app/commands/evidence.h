#pragma once

#include "commands/verdict.h"

#include <filesystem>
#include <vector>

namespace normalscope {

// What somebody who looks into a failure needs, beside the actual picture's file OUT.png.

/// OUT.difference.png and, unless that is the reference itself, OUT.expected.png.
std::vector<std::filesystem::path> evidence_files(const std::filesystem::path& actual_file,
                                                  const std::filesystem::path& reference);
/// Writes them, and says which. Throws InputError.
std::vector<std::filesystem::path> leave_evidence(const std::filesystem::path& actual_file,
                                                  const std::filesystem::path& reference, const Image& actual,
                                                  const Image& expected, const Tolerance& tolerance);
/// Removes what leave_evidence left in an earlier run: it would tell of a failure that is none any more.
void remove_evidence(const std::filesystem::path& actual_file, const std::filesystem::path& reference);

}  // namespace normalscope

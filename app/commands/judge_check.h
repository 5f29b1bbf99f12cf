#pragma once

#include "commands/check_result.h"
#include "commands/manifest.h"
#include "commands/studio.h"

#include <filesystem>

namespace normalscope {

/// Where the picture of a check goes that does not pass; a name may hold what a file's name may not.
std::filesystem::path evidence_file(const CheckCommand& command, const Check& check);

/// A picture as it was drawn becomes a result, and leaves evidence where it does not pass. Needs no graphics context.
CheckResult judge_check(const CheckCommand& command, const Check& check, Capture capture);

/// Where there was nothing to judge.
CheckResult error_result(const Check& check, const std::string& reason);

/// What tells a picture from another in the evidence.
std::uint64_t hash_of(std::string_view bytes);

}  // namespace normalscope

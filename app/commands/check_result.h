#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// What a check came to; Error is where there was nothing to compare, Skipped where the run was cut short before it.
enum class CheckState { Pass, Fail, Error, Skipped };
constexpr std::string_view name(CheckState state) {
    constexpr std::string_view kNames[]{"pass", "fail", "error", "skipped"};
    return kNames[static_cast<int>(state)];
}

struct CheckResult {
    std::string name;
    CheckState state = CheckState::Skipped;
    std::string line;
    double seconds = 0.0;
    /// What the report shows besides: `pictures` (PNGs as base64: actual, expected, difference), `verdict` and `numbers`.
    std::string details = "{}";                     ///< JSON text
    std::vector<std::filesystem::path> evidence{};  ///< files written, the first of which says most
    std::uint64_t drawn = 0;                        ///< a hash of the PNG among the evidence
    bool reference_differs = false;                 ///< or does not exist: --update would write it
    bool numbers_wrong = false;                     ///< which no update cures
};

/// A result as text and back, since it may come from another process.
std::string packed(const CheckResult& result);
CheckResult unpacked(const std::string& text);

}  // namespace normalscope

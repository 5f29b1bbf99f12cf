#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace normalscope {

/// What a check came to: "pass", "fail", or "error" where there was nothing to compare.
struct CheckResult {
    std::string name, state, line;
    double seconds = 0.0;
    /// What the report shows besides: `pictures` (PNGs as base64: actual, expected, difference), `verdict` and `numbers`.
    std::string details;             ///< JSON text
    bool reference_differs = false;  ///< or does not exist: --update would write it
    bool numbers_wrong = false;      ///< which no update cures
};

/// As CI services read it.
std::string junit_xml(const std::string& suite, const std::vector<CheckResult>& results);

/// One HTML file that needs no other: pictures with a slider, filters, numbers.
std::string html_report(const std::string& title, const std::vector<CheckResult>& results);

std::string base64(const std::string& bytes);

}  // namespace normalscope

#pragma once

#include "commands/check_result.h"

#include <string>
#include <vector>

namespace normalscope {

/// One HTML file that needs no other: pictures with a slider, filters, numbers.
std::string html_report(const std::string& title, const std::vector<CheckResult>& results);

}  // namespace normalscope

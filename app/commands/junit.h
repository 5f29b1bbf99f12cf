#pragma once

#include "commands/check_result.h"

#include <string>
#include <vector>

namespace normalscope {

/// The results as CI services read them: JUnit's XML, well formed whatever names and reasons hold. A failure's reason is
/// the element's text as well as its message, since services differ in which they show; its evidence is named in the way
/// that GitLab and Jenkins take for attachments.
std::string junit_xml(const std::string& suite, const std::vector<CheckResult>& results);

}  // namespace normalscope

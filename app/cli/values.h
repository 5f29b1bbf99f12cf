#pragma once

// Options' values from text. Each throws UsageError with the option, what was given and what is allowed.

#include "cli/options.h"

namespace normalscope {

glm::ivec2 parse_size(const std::string& option, const std::string& text);
int parse_samples(const std::string& option, const std::string& text);
ContextChoice parse_context(const std::string& option, const std::string& text);
ExplainFormat parse_format(const std::string& option, const std::string& text);
int parse_tolerance(const std::string& option, const std::string& text);
double parse_share(const std::string& option, const std::string& text);
/// "-" is standard output.
std::filesystem::path parse_output(const std::string& option, const std::string& text);

}  // namespace normalscope

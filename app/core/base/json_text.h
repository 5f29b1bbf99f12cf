#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace normalscope {

/// JSON as people like to read it: two spaces of indentation, and arrays of plain values on one line.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace normalscope

#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace normalscope {

/// How deep arrays and objects are nested in JSON text, valid or not.
int json_depth(std::string_view text);

/// JSON from outside. Throws InputError, one line that begins with `source`, where it is not valid or nested deeper than
/// `deepest`, which would overflow the stack of whoever writes it into an error. (The parser's own callback could tell the
/// depth, but makes it take quadratic time.)
nlohmann::ordered_json read_json(std::string_view text, const std::string& source, int deepest);

/// Empty where it is not valid, or too deep.
std::optional<nlohmann::ordered_json> read_json_or_nothing(std::string_view text, int deepest);

}  // namespace normalscope

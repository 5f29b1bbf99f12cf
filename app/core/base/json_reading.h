#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>

namespace normalscope {

/// How deep arrays and objects may be nested: nothing of ours is half as deep, and more would overflow the stack of
/// whoever walks through it.
inline constexpr int kDeepestJson = 40;

/// JSON from outside. Throws JsonError where it is not valid, nested too deep, holds a number that is none, or the same
/// key twice in one object, of which JSON would silently drop one.
nlohmann::ordered_json read_json(std::string_view text);

/// Empty where it is not JSON; what is, but has another of those faults, throws JsonError.
std::optional<nlohmann::ordered_json> read_json_or_nothing(std::string_view text);

}  // namespace normalscope

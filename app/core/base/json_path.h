#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <string>
#include <vector>

namespace normalscope {

/// Where a value stands in JSON: keys and indices, the outermost first.
using JsonPath = std::vector<std::string>;

JsonPath below(JsonPath path, std::string key);
JsonPath below(JsonPath path, std::size_t index);

/// "stack.0.scale.1", where very long keys are shortened.
std::string dotted(const JsonPath& path);

/// Something is wrong with one value within JSON: "stack.0.scale.1: expected a number". Whoever knows where the JSON is
/// from makes an InputError of it, or a UsageError, that names that, too.
struct JsonError : InputError {
    JsonError(JsonPath where, const std::string& reason_alone);
    JsonPath path;
};

}  // namespace normalscope

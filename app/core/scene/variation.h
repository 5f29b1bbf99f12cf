#pragma once

#include "core/scene/setting.h"

#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// What `--vary PATH=FROM:TO[:COUNT]` stands for: one key of a scene, and the values that it takes in turn.
struct Variation {
    std::string path;
    std::vector<nlohmann::ordered_json> values;  ///< the first one FROM and the last one TO

    Setting setting(std::size_t i) const { return {path, values[i]}; }
};

/// FROM and TO are numbers, or arrays of numbers of one shape; COUNT is `usual_count` where it is not given.
/// Throws UsageError.
Variation parse_variation(std::string_view text, std::size_t usual_count);

}  // namespace normalscope

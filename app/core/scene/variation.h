#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// What `--vary PATH=FROM:TO[:COUNT]` stands for: one key of a scene, and the values that it takes in turn.
struct Variation {
    std::string path;
    std::vector<std::string> values;  ///< JSON text each, the first one FROM and the last one TO

    /// "PATH=VALUE", as with_setting takes it.
    std::string setting(std::size_t i) const { return path + "=" + values[i]; }
};

/// FROM and TO are numbers, or arrays of numbers of one shape; COUNT is `usual_count` where it is not given.
/// Throws UsageError.
Variation parse_variation(std::string_view text, std::size_t usual_count);

}  // namespace normalscope

#pragma once

#include "core/image/image_difference.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace normalscope {

/// What a comparison of two pictures comes to.
struct Verdict {
    bool agree = false;
    glm::ivec2 actual_size{0}, expected_size{0};
    std::optional<ImageDifference> difference;  ///< where the sizes are the same
    Tolerance tolerance;

    /// One line that says how far they are apart, without "agree" or "differ".
    std::string line() const;
    nlohmann::ordered_json json() const;
};

Verdict judge(const Image& actual, const Image& expected, const Tolerance& tolerance);

}  // namespace normalscope

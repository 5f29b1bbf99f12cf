#pragma once

#include "core/image/image_difference.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
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

/// Writes what somebody who looks into a failure needs beside the actual picture's file: OUT.expected.png, unless that is
/// the reference itself, and OUT.difference.png.
void leave_evidence(const std::filesystem::path& actual_file, const Image& actual,
                    const std::filesystem::path& reference, const Image& expected, const Tolerance& tolerance);
/// Removes what leave_evidence left in an earlier run: it would tell of a failure that is none any more.
void remove_evidence(const std::filesystem::path& actual_file, const std::filesystem::path& reference);

}  // namespace normalscope

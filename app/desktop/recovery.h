#pragma once

#include "core/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace normalscope {

/// The last state of a scene that is not saved, in a file of this process' own: whoever finds one whose process is gone
/// can offer what it holds.
class Recovery {
public:
    explicit Recovery(std::optional<std::filesystem::path> folder);

    /// What an earlier process has left, once.
    std::optional<Scene> left_behind() const;
    /// Empty: nothing. Where it cannot be written, nothing is said: people are in the middle of something.
    void keep(const std::string& scene) const;

private:
    std::optional<std::filesystem::path> folder_;
};

}  // namespace normalscope

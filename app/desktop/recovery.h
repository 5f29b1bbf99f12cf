#pragma once

#include "core/lessons/unsaved_work.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// Work that is not saved, in a file of this process' own: whoever finds one whose process is gone can offer what it holds.
class Recovery {
public:
    explicit Recovery(std::optional<std::filesystem::path> folder);

    /// What earlier processes have left, the newest last. Their files stay until keep() says what becomes of it.
    std::vector<UnsavedWork> left_behind();
    /// Empty: nothing. Where it cannot be written, nothing is said: people are in the middle of something.
    void keep(const std::string& unsaved);

private:
    std::optional<std::filesystem::path> folder_, own_;
    std::vector<std::filesystem::path> found_;
};

}  // namespace normalscope

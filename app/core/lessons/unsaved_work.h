#pragma once

#include "core/lessons/writing.h"
#include "core/scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// A scene that no file holds as it is, and the file or name that it was opened by, or empty; or such a lesson, which is
/// being written.
struct UnsavedWork {
    std::string file;
    Scene scene;
    Draft draft{};
    friend bool operator==(const UnsavedWork&, const UnsavedWork&) = default;
};

/// What one session leaves to the next, wherever that one is started: paths are absolute.
std::string unsaved_text(std::span<const UnsavedWork> works);

/// The same works back. `source` names the text in errors. Throws InputError.
std::vector<UnsavedWork> parse_unsaved(std::string_view text, const std::string& source);

/// The scene that a file holds; empty where that is gone, or holds none, or there was none.
std::optional<Scene> saved_scene(const std::string& file);

}  // namespace normalscope

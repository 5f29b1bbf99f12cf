#pragma once

#include "core/lessons/lesson.h"
#include "core/scene/scene.h"
#include "core/surface/surface.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace normalscope {

/// A file, with all that takes time already done.
struct Opened {
    std::string file;
    Scene scene;
    std::unique_ptr<SurfaceCache> surfaces = std::make_unique<SurfaceCache>();  ///< holds the scene's surface
    std::shared_ptr<const Lesson> lesson{};                                     ///< instead of a scene
    std::optional<std::size_t> step{};                                          ///< of the lesson, if one was asked for
    std::optional<std::uint64_t> exercises{};                                   ///< instead of a scene: their seed
};

/// A lesson, a step of one, or exercises. Throws InputError.
bool is_more_than_a_scene(const std::string& file);

/// A scene, a link, or a lesson; a mesh changes the surface of `scene` and no more. Throws InputError.
Opened open_file(const std::string& file, const Scene& scene);

}  // namespace normalscope

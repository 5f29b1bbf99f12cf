#pragma once

#include "core/lessons/lesson.h"
#include "core/scene/scene.h"
#include "core/surface/surface.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace normalscope {

/// What a file, or whatever else has a name, holds.
struct Opened {
    std::string file;  ///< or the name; empty for what has none: a link, standard input
    Scene scene;
    std::unique_ptr<SurfaceCache> surfaces = std::make_unique<SurfaceCache>();  ///< those that are made
    std::shared_ptr<const Lesson> lesson{};                                     ///< instead of a scene
    std::optional<std::size_t> step{};                                          ///< of the lesson, if one was asked for
    std::optional<std::uint64_t> exercises{};                                   ///< instead of a scene: their seed
};

/// Reads it: a scene, a link, a lesson or exercises; a mesh changes the surface of `scene` and no more. Throws InputError.
Opened read_file(const std::string& file, const Scene& scene);
/// The files of its surface, and of its lesson's steps.
std::set<std::string> meshes_of(const Opened& opened);
/// Does what takes time: makes the scene's surface, and reads every mesh of a lesson, which must not fail in the middle of a
/// lecture. Throws InputError.
void prepare(Opened& opened);
/// Both in one.
Opened open_file(const std::string& file, const Scene& scene);

}  // namespace normalscope

#pragma once

#include "core/lessons/exercise.h"
#include "core/lessons/lesson.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace normalscope {

/// A mesh's file, whose name is all that has been read.
struct MeshFile {
    std::string file;
};
struct OpenedLesson {
    std::shared_ptr<const Lesson> lesson;
    std::optional<std::size_t> step;  ///< counted from 0; empty: none was asked for
};
/// What a FILE is, whatever it was named by.
using Contents = std::variant<Scene, MeshFile, OpenedLesson, ExercisesName>;

/// The one way from a name to what it means: a scene's or a lesson's file (.json, whose mesh paths are taken relative to
/// it), a mesh's, a built-in scene or lesson, a lesson's n-th step ("NAME#n", or "NAME/n"), a link, a page's address, exercises, or
/// standard input ("-"), which holds a scene, a lesson or a link. A file is read once. Throws InputError.
Contents open_name(const std::string& name);

/// What is seen of it first: of a lesson its step, of a mesh file itself in the default scene, of exercises the first.
Scene first_scene(const Contents& contents);

/// Both in one. Throws InputError.
Scene load_scene(const std::string& name);
/// Where nothing but a lesson will do, or `others` (", all"), which an error names beside the lessons. Throws InputError.
Lesson load_lesson(const std::string& name, std::string_view others = {});
/// The same, and of "all" every built-in one.
std::vector<Lesson> load_lessons(const std::string& name, std::string_view others = {});

/// The scene with a mesh file as its surface and all else kept.
Scene with_mesh(Scene scene, const std::string& file);

/// The scene as a file holds it: a mesh is named from there.
Scene as_saved_in(Scene scene, const std::filesystem::path& file);
/// Writes to a temporary file and renames, so that a full disk or a kill loses nothing. Throws InputError.
void save_scene(const Scene& scene, const std::filesystem::path& file);

struct BuiltInScene {
    std::string name;
    std::string about;  ///< one line
};
bool is_built_in_scene(const std::string& name);
/// The built-in scenes in alphabetical order, from assets/scenes.
std::vector<BuiltInScene> built_in_scenes();
/// What the names of the surfaces by formula begin with.
inline constexpr std::string_view kGalleryPrefix = "implicit-";
inline constexpr std::string_view kDefaultScene = "slide-scale";

}  // namespace normalscope

#pragma once

#include "core/scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// Whether the file's ending is a mesh's: .obj, .ply or .stl, in any case.
bool is_mesh_file(const std::filesystem::path& file);
/// The scene with a mesh file as its surface and all else kept.
Scene with_mesh(Scene scene, const std::string& file);

/// Reads a scene (.json, its mesh path taken relative to the file) or wraps a mesh file (.obj, .ply, .stl) into the
/// default scene; a built-in scene's name, a link (core/link.h) and a lesson or its n-th step ("NAME#n") work too. Throws
/// InputError.
Scene load_scene(const std::string& file_or_name);
/// Writes to a temporary file and renames, so that a full disk or a kill loses nothing. Throws InputError.
void save_scene(const Scene& scene, const std::filesystem::path& file);

struct BuiltInScene {
    std::string name;
    std::string about;  ///< one line
};
/// The built-in scenes in alphabetical order, from assets/scenes.
std::vector<BuiltInScene> built_in_scenes();
/// What the names of the surfaces by formula begin with.
inline constexpr std::string_view kGalleryPrefix = "implicit-";
inline constexpr std::string_view kDefaultScene = "slide-scale";

}  // namespace normalscope

#pragma once

#include "core/scene.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// The scene as JSON text, every key written, two spaces of indentation; parse_scene gives the same scene back.
std::string scene_text(const Scene& scene);

/// A scene from JSON text. `source` names the text in errors. A missing key takes its default; an unknown key, a wrong
/// type or a value out of range throws InputError with the path, such as "lecture.json: stack.0.scale.1: …".
Scene parse_scene(std::string_view text, std::string_view source);

/// Applies "PATH=VALUE" (a dotted path and a JSON value; a bare word is a string), as `--set` gives it.
/// Throws UsageError for what is not of that form, InputError for what the scene does not allow.
Scene with_setting(const Scene& scene, std::string_view assignment);

/// Whether the file's ending is a mesh's: .obj, .ply or .stl, in any case.
bool is_mesh_file(const std::filesystem::path& file);
/// The scene with a mesh file as its surface and all else kept.
Scene with_mesh(Scene scene, const std::string& file);

/// Reads a scene (.json, its mesh path taken relative to the file) or wraps a mesh file (.obj, .ply, .stl) into the
/// default scene; a built-in scene's name works too. Throws InputError.
Scene load_scene(const std::string& file_or_name);
/// Writes to a temporary file and renames, so that a full disk or a kill loses nothing. Throws InputError.
void save_scene(const Scene& scene, const std::filesystem::path& file);

struct BuiltInScene {
    std::string name;
    std::string about;  ///< one line
};
/// The built-in scenes in alphabetical order, from assets/scenes.
std::vector<BuiltInScene> built_in_scenes();
inline constexpr std::string_view kDefaultScene = "slide-scale";

std::string_view name(Shape);
std::string_view name(ViewMode);
std::string_view name(ArrowPlacement);
std::string_view name(ArrowKind);
std::string_view name(Mistake);
std::string_view name(SurfaceColor);
std::string_view name(Theme);

}  // namespace normalscope

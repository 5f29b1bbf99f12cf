#pragma once

#include "core/base/json_path.h"
#include "core/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// The scene as JSON, every key written; scene_of_json gives the same scene back.
nlohmann::ordered_json scene_json(const Scene& scene);

/// A missing key takes its default; an unknown key, a wrong type or a value out of range throws JsonError. `path` is where
/// the scene stands within JSON of other things.
Scene scene_of_json(const nlohmann::ordered_json& json, const JsonPath& path = {});

/// The same as text, with two spaces of indentation.
std::string scene_text(const Scene& scene);

/// `source` names the text in errors, such as "lecture.json: stack.0.scale.1: …". Throws InputError.
Scene parse_scene(std::string_view text, const std::string& source);

/// The keys of which a surface has one, and an entry of the stack: they say what it is.
std::span<const std::string> surface_kinds();
std::span<const std::string> stack_kinds();

/// What a key that is null (a slice, a neighbour's normal, a ray) is when it is switched on; null for other keys.
nlohmann::ordered_json json_when_on(std::string_view key);

/// Whether both show the same object under the same transform, so that what one says of it (`about`) holds for the other.
bool same_subject(const Scene& a, const Scene& b);

std::string_view name(Shape);
std::string_view name(ViewMode);
std::string_view name(ArrowPlacement);
std::string_view name(ArrowKind);
std::string_view name(Mistake);
std::string_view name(SurfaceColor);
std::string_view name(Theme);

}  // namespace normalscope

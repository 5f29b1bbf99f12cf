#pragma once

#include "core/scene/scene.h"

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

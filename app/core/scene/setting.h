#pragma once

#include "core/scene/scene.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// One change of a scene, as `--set PATH=VALUE` gives it: a dotted path into the scene's JSON, and what is put there.
struct Setting {
    std::string path;
    nlohmann::ordered_json value;

    /// "PATH=VALUE", as people write it: a name needs no quotes.
    std::string text() const;
};

/// A value that is no JSON is a bare word, and so a string. Throws UsageError for what is not of that form, which begins
/// with "--set".
Setting parse_setting(std::string_view text);

/// Throws JsonError for what the scene does not allow.
Scene with_setting(const Scene& scene, const Setting& setting);

/// The same from "PATH=VALUE", as `--set` has it. Throws UsageError.
Scene with_setting(const Scene& scene, std::string_view assignment);

/// What makes of one scene another; few and short ones. What the scene says about itself is left out, since it shows in
/// no picture.
std::vector<Setting> settings_between(const Scene& from, const Scene& to);

}  // namespace normalscope

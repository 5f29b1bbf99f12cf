#pragma once

// What the picture options of a command line mean.

#include "cli/commands.h"
#include "commands/studio.h"

namespace normalscope {

/// The scene after each "PATH=VALUE". Throws as with_setting does.
Scene with_settings(Scene scene, const std::vector<std::string>& settings);
/// What FILE names, so changed.
Scene scene_for(const std::string& file, const std::vector<std::string>& settings);

CaptureOptions capture_options(const PictureArguments& arguments, bool numbers);

}  // namespace normalscope

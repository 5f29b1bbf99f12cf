#pragma once

// What the picture options of a command line mean.

#include "cli/commands.h"
#include "commands/studio.h"

namespace normalscope {

/// What FILE names, read once, after each "PATH=VALUE".
struct Subject {
    Scene scene;
    std::shared_ptr<const Lesson> lesson;  ///< empty where the scene is no lesson's step
    std::size_t step = 0;
};
/// Throws InputError, and UsageError for what `settings` may not do.
Subject subject_of(const std::string& file, const std::vector<std::string>& settings);

/// How it is drawn. Throws UsageError where captions are asked for, and there are none.
CaptureOptions capture_options(const PictureArguments& arguments, const Subject& subject);

}  // namespace normalscope

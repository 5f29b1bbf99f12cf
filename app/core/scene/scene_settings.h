#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace normalscope {

/// The "PATH=VALUE" that with_setting takes, one after the other, to make of one scene another; few and short ones. What
/// the scene says about itself is left out, since it shows in no picture.
std::vector<std::string> settings_between(const Scene& from, const Scene& to);

/// The text as one word of a POSIX shell.
std::string shell_word(const std::string& text);

}  // namespace normalscope

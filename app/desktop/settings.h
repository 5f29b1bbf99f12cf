#pragma once

#include "core/picture/display_scale.h"
#include "platform/window.h"

#include <map>
#include <string>

namespace normalscope {

/// What is remembered from one session to the next, in $XDG_CONFIG_HOME/normalscope/settings.json.
struct Settings {
    WindowPlace place;
    DisplayScale scale;
    std::string monitor;                         ///< chosen for presenting; empty: the one that the window is on
    std::map<std::string, std::size_t> lessons;  ///< the step at which each was left
};

/// A missing or damaged file gives the defaults: nobody's work depends on it.
Settings load_settings();
/// Silently keeps the old file where it cannot be written.
void save_settings(const Settings& settings);

}  // namespace normalscope

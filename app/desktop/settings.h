#pragma once

#include "platform/window.h"
#include "viewer/remembered.h"

#include <filesystem>
#include <optional>
#include <string>

namespace normalscope {

/// What is remembered from one session to the next, in $XDG_CONFIG_HOME/normalscope/settings.json.
struct Settings {
    WindowPlace place;
    std::string monitor;  ///< chosen for presenting; empty: the one that the window is on
    Remembered remembered;
};

/// Where the settings are; empty where there is no home.
std::optional<std::filesystem::path> settings_folder();

/// A missing or damaged file gives the defaults: nobody's work depends on it.
Settings load_settings();
/// Silently keeps the old file where it cannot be written.
void save_settings(const Settings& settings);

}  // namespace normalscope

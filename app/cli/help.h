#pragma once

#include <string>

namespace CLI {
class App;
}

namespace normalscope {

/// "normalscope capture [OPTIONS] [FILE]"
std::string usage_line(const CLI::App& app);

/// A command's help from its declared options, at most 100 columns wide. Laid out here because CLI11's own layout
/// differs from version to version.
std::string help_text(const CLI::App& app);

// What is installed beside the program, from the same declarations.

/// The manual page, as troff.
std::string manual_page();
/// What completes a command line; the shells are bash, zsh and fish.
std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace normalscope

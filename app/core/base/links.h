#pragma once

#include <filesystem>

namespace normalscope {

/// Where a name leads that may be a link, or a link to a link, even where there is nothing yet: the file that is written.
std::filesystem::path without_links(const std::filesystem::path& file);

}  // namespace normalscope

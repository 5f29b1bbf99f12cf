#pragma once

#include <filesystem>

namespace normalscope {

/// The program as a page, where it was brought along or built with this one; empty where it was not.
std::filesystem::path own_page();

}  // namespace normalscope

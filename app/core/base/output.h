#pragma once

#include <filesystem>
#include <string_view>

namespace normalscope {

/// To standard output, at once. Throws InputError.
void print(std::string_view bytes);

/// Where a result goes.
struct Output {
    std::filesystem::path file;  ///< empty: standard output
    bool is_standard() const { return file.empty(); }
};
/// As write_file or print does.
void write(const Output& to, std::string_view bytes);

}  // namespace normalscope

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace normalscope {

/// The whole file. Throws InputError: missing, unreadable, a folder, or larger than `largest` bytes.
std::string read_file(const std::filesystem::path& file, std::size_t largest);
/// The same of standard input, until its end.
std::string read_standard_input(std::size_t largest);
/// What that has given, for processes that are to read the same. Empty: nothing yet.
const std::string& standard_input_so_far();

/// Writes beside the file and renames, so that whoever stops half way (a full disk, a kill) loses nothing that was
/// there before. "/dev/stdout" and other things that are not plain files are written directly. Throws InputError.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace normalscope

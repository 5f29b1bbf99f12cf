#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// A file, from some place on. Throws InputError: missing, unreadable, a folder, or larger than `largest` bytes.
class FileReader {
public:
    FileReader(const std::filesystem::path& file, std::size_t largest, std::size_t from = 0);
    /// Its size, as a hint only: a file may grow meanwhile. None of what has none, such as a pipe.
    std::optional<std::size_t> size() const { return size_; }
    /// So many bytes more; fewer, or none, at the file's end.
    std::size_t read(std::span<char> to);
    /// All that are left.
    std::string read_all();

private:
    friend std::string read_standard_input(std::size_t largest);
    FileReader(std::FILE* stream, std::string name, std::size_t largest);

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
    std::string name_;
    std::size_t largest_, so_far_ = 0;
    std::optional<std::size_t> size_;
};

/// The whole file. Throws InputError: missing, unreadable, a folder, or larger than `largest` bytes.
std::string read_file(const std::filesystem::path& file, std::size_t largest);
/// The same of standard input, until its end.
std::string read_standard_input(std::size_t largest);
/// What that has given, for processes that are to read the same. Empty: nothing yet.
const std::string& standard_input_so_far();

/// Writes beside the file and renames, so that whoever stops half way (a full disk, a kill) loses nothing that was
/// there before. "/dev/stdout" and other things that are not plain files are written directly. Throws InputError.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Makes a folder, and those that it is in, where there is none. Throws InputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace normalscope

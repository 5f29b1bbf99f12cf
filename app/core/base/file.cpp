#include "core/base/file.h"

#include "core/base/error.h"
#include "core/base/links.h"
#include "core/base/system.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace normalscope {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view what, int error) {
    throw InputError(file.string(), std::string(what) + ": " + std::strerror(error));
}

std::FILE* open_to_write(const std::filesystem::path& file, const char* mode) {
    errno = 0;
    std::FILE* stream = open_file(file, mode);
    if (!stream) fail(file, "cannot be written", errno);
    return stream;
}

struct Partial {
    std::filesystem::path file;
    std::FILE* stream;
};
// A file beside the one that it will become, which nobody else writes: not another thread, and not a process of the same
// number in another container that shares the folder.
Partial open_partial(const std::filesystem::path& shown_as, const std::filesystem::path& file) {
    for (int i = 0;; ++i) {
        std::filesystem::path partial = file;
        partial += ".part" + std::to_string(process_id()) + (i > 0 ? "." + std::to_string(i) : "");
        errno = 0;
        if (std::FILE* stream = create_file(partial)) return {partial, stream};
        if (errno != EEXIST || i == 100) fail(shown_as, "cannot be written", errno);
    }
}

void write_all(const std::filesystem::path& shown_as, std::FILE* file, std::string_view bytes) {
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
    const int error = errno;
    // A full disk may show itself only when the file is closed.
    if (std::fclose(file) != 0 || !written) fail(shown_as, "cannot be written", written ? errno : error);
}

[[noreturn]] void too_large(const std::string& name, std::size_t largest) {
    throw InputError(name, "is larger than " + std::to_string(largest >> 20) + " MiB, the most that is read");
}

std::string& standard_input() {
    static std::string text;
    return text;
}

constexpr std::size_t kUsualSize = std::size_t{1} << 16;

}  // namespace

FileReader::FileReader(std::FILE* stream, std::string name, std::size_t largest)
    : stream_(stream, [](std::FILE*) { return 0; }), name_(std::move(name)), largest_(largest) {}

FileReader::FileReader(const std::filesystem::path& file, std::size_t largest, std::size_t from)
    : stream_(nullptr, std::fclose), name_(file.string()), largest_(largest), so_far_(from) {
    if (file.native().find('\0') != file.native().npos) throw InputError(name_, "a file's name cannot hold a NUL");
    std::error_code ignored, unknown;
    if (std::filesystem::is_directory(file, ignored)) throw InputError(name_, "is a folder, not a file");
    errno = 0;
    stream_.reset(open_file(file, "rb"));
    if (!stream_ || (from > 0 && std::fseek(stream_.get(), static_cast<long>(from), SEEK_SET) != 0))
        fail(file, "cannot be read", errno);
    const std::uintmax_t size = std::filesystem::file_size(file, unknown);
    if (unknown) return;
    if (size > largest) too_large(name_, largest);
    size_ = static_cast<std::size_t>(size);
}

std::size_t FileReader::read(std::span<char> to) {
    const std::size_t got = std::fread(to.data(), 1, to.size(), stream_.get());
    if (std::ferror(stream_.get())) fail(name_, "cannot be read", errno);
    so_far_ += got;
    if (so_far_ > largest_) too_large(name_, largest_);
    return got;
}

std::string FileReader::read_all() {
    const std::size_t room = size_.value_or(kUsualSize) + 1;
    std::string bytes;
    bytes.reserve(room);
    prefer_large_pages(bytes.data(), room);
    bytes.resize(room);
    std::size_t filled = 0;
    while (const std::size_t got = read(std::span(bytes).subspan(filled)))
        if ((filled += got) == bytes.size()) bytes.resize(2 * filled);
    bytes.resize(filled);
    return bytes;
}

std::string read_file(const std::filesystem::path& file, std::size_t largest) {
    return FileReader(file, largest).read_all();
}

std::string read_standard_input(std::size_t largest) {
    return standard_input() = FileReader(stdin, "standard input", largest).read_all();
}
const std::string& standard_input_so_far() { return standard_input(); }

void write_file(const std::filesystem::path& file, std::string_view bytes) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (std::filesystem::is_directory(status)) throw InputError(file.string(), "is a folder, not a file");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        return write_all(file, open_to_write(file, "wb"), bytes);

    const std::filesystem::path end = without_links(file);  // a link stays one
    const std::filesystem::path folder = end.has_parent_path() ? end.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, error))
        throw InputError(file.string(), "cannot be written: there is no folder " + folder.string());
    const bool is_there = std::filesystem::exists(status);
    const auto [partial, stream] = open_partial(file, end);
    try {
        write_all(file, stream, bytes);
        if (is_there) std::filesystem::permissions(partial, status.permissions(), error);  // private stays private
        replace_file(partial, end);
    } catch (const std::system_error& e) {
        std::filesystem::remove(partial, error);
        throw InputError(file.string(), "cannot be written: " + e.code().message());
    } catch (...) {
        std::filesystem::remove(partial, error);
        throw;
    }
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error))
        throw InputError(folder.string(), "is a file, where a folder is wanted");
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(folder.string(), "cannot be made: " + error.message());
}

}  // namespace normalscope

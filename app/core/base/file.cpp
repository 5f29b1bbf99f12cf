#include "core/base/file.h"

#include "core/base/error.h"
#include "core/base/links.h"
#include "core/base/system.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace normalscope {

namespace {

struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Close>;

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

// `room` is how large it is expected to be.
std::string read_all(std::FILE* in, const std::string& name, std::size_t room, std::size_t largest) {
    std::string bytes;
    bytes.reserve(room);
    prefer_large_pages(bytes.data(), room);
    bytes.resize(room);
    std::size_t filled = 0;
    while (const std::size_t got = std::fread(bytes.data() + filled, 1, bytes.size() - filled, in)) {
        filled += got;
        if (filled > largest) too_large(name, largest);
        if (filled == bytes.size()) bytes.resize(2 * filled);
    }
    if (std::ferror(in)) fail(name, "cannot be read", errno);
    bytes.resize(filled);
    return bytes;
}

std::string& standard_input() {
    static std::string text;
    return text;
}

constexpr std::size_t kUsualRoom = std::size_t{1} << 16;

}  // namespace

std::string read_file(const std::filesystem::path& file, std::size_t largest) {
    if (file.native().find('\0') != file.native().npos)
        throw InputError(file.string(), "a file's name cannot hold a NUL");
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) throw InputError(file.string(), "is a folder, not a file");
    errno = 0;
    const File in(open_file(file, "rb"));
    if (!in) fail(file, "cannot be read", errno);
    // The size that the file says it has is a hint only: a pipe says nothing, and a file may grow meanwhile.
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(file, unknown);
    if (!unknown && size > largest) too_large(file.string(), largest);
    return read_all(in.get(), file.string(), unknown ? kUsualRoom : static_cast<std::size_t>(size) + 1, largest);
}

std::string read_standard_input(std::size_t largest) {
    std::string& text = standard_input();
    text = read_all(stdin, "standard input", kUsualRoom, largest);
    return text;
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
    const auto [partial, stream] = open_partial(file, end);
    try {
        write_all(file, stream, bytes);
        replace_file(partial, end);
    } catch (const std::system_error& e) {
        std::filesystem::remove(partial, error);
        throw InputError(file.string(), "cannot be written: " + e.code().message());
    } catch (...) {
        std::filesystem::remove(partial, error);
        throw;
    }
}

}  // namespace normalscope

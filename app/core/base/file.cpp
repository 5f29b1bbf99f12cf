#include "core/base/file.h"

#include "core/base/error.h"

#include <sys/mman.h>
#include <unistd.h>

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
    throw InputError(file.string() + ": " + std::string(what) + ": " + std::strerror(error));
}

// For a file of many megabytes, to get one small page after the other takes longer than to read it.
void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::size_t kLarge = std::size_t{2} << 20;
    std::size_t space = bytes;
    if (std::align(kLarge, kLarge, begin, space)) ::madvise(begin, space, MADV_HUGEPAGE);  // a wish; may go unheard
#endif
}

void write_all(const std::filesystem::path& shown_as, const std::filesystem::path& to, std::string_view bytes) {
    errno = 0;
    std::FILE* file = std::fopen(to.c_str(), "wb");
    if (!file) fail(shown_as, "cannot be written", errno);
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
    const int error = errno;
    // A full disk may show itself only when the file is closed.
    if (std::fclose(file) != 0 || !written) fail(shown_as, "cannot be written", written ? errno : error);
}

}  // namespace

std::string read_file(const std::filesystem::path& file, std::size_t largest) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) throw InputError(file.string() + ": is a folder, not a file");
    errno = 0;
    const File in(std::fopen(file.c_str(), "rb"));
    if (!in) fail(file, "cannot be read", errno);
    const auto too_large = [&] {
        throw InputError(file.string() + ": is larger than " + std::to_string(largest >> 20) +
                         " MiB, the most that is read");
    };
    // The size that the file says it has is a hint only: a pipe says nothing, and a file may grow meanwhile.
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(file, unknown);
    if (!unknown && size > largest) too_large();
    std::string bytes;
    const std::size_t room = unknown ? std::size_t{1} << 16 : static_cast<std::size_t>(size) + 1;
    bytes.reserve(room);
    prefer_large_pages(bytes.data(), room);
    bytes.resize(room);
    std::size_t filled = 0;
    while (const std::size_t got = std::fread(bytes.data() + filled, 1, bytes.size() - filled, in.get())) {
        filled += got;
        if (filled > largest) too_large();
        if (filled == bytes.size()) bytes.resize(2 * filled);
    }
    if (std::ferror(in.get())) fail(file, "cannot be read", errno);
    bytes.resize(filled);
    return bytes;
}

void write_file(const std::filesystem::path& file, std::string_view bytes) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    // The stream itself: where it is a plain file, a rename would replace that file, or the link.
    if (file == "/dev/stdout") {
        errno = 0;
        if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
            fail("standard output", "cannot be written", errno);
        return;
    }
    if (std::filesystem::is_directory(status)) throw InputError(file.string() + ": is a folder, not a file");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        return write_all(file, file, bytes);

    // A link stays one: it is what it points to that is written anew.
    if (std::filesystem::is_symlink(file, error)) {
        const std::filesystem::path target = std::filesystem::weakly_canonical(file, error);
        if (!error && target != file) return write_file(target, bytes);
    }
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, error))
        throw InputError(file.string() + ": cannot be written: there is no folder " + folder.string());
    std::filesystem::path partial = file;
    partial += ".part" + std::to_string(::getpid());
    try {
        write_all(file, partial, bytes);
        std::filesystem::rename(partial, file);
    } catch (const std::filesystem::filesystem_error& e) {
        std::filesystem::remove(partial, error);
        fail(file, "cannot be written", e.code().value());
    } catch (...) {
        std::filesystem::remove(partial, error);
        throw;
    }
}

}  // namespace normalscope

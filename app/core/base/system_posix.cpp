#include "core/base/system.h"

#include "core/base/posix_arguments.h"

#include <pwd.h>
#include <signal.h>  // kill, signal
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <locale.h>  // newlocale
#if __has_include(<malloc.h>)
#include <malloc.h>  // glibc has mallopt there
#endif
#if __has_include(<xlocale.h>)
#include <xlocale.h>  // a Mac has it there
#endif

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <climits>
#include <clocale>
#include <cstdlib>
#include <cwchar>
#include <cwctype>
#include <memory>
#include <string_view>
#include <system_error>

namespace normalscope {

namespace {

std::string identity(const struct stat& status) {
    return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
}

char** arguments = nullptr;  // those of main, which last as long as the program runs

}  // namespace

void begin_process(int&, char**& argv) {
    arguments = argv;
    ::signal(SIGXFSZ, SIG_IGN);  // a write that a limit forbids fails, as on a full disk
}
char** own_arguments() { return arguments; }
int process_id() { return ::getpid(); }
bool process_runs(int id) { return ::kill(id, 0) == 0 || errno == EPERM; }

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

void set_variable(const char* name, const std::optional<std::string>& value) {
    if (value)
        ::setenv(name, value->c_str(), 1);
    else
        ::unsetenv(name);
}

std::filesystem::path home_folder() {
    if (std::string home = variable("HOME"); !home.empty()) return home;
    // As for Mesa: services often have none in their environment.
    std::array<char, 4096> text{};
    passwd entry{}, *found = nullptr;
    ::getpwuid_r(::getuid(), &entry, text.data(), text.size(), &found);
    return found && found->pw_dir ? found->pw_dir : "";
}

std::FILE* open_file(const std::filesystem::path& file, const char* mode) { return std::fopen(file.c_str(), mode); }
std::FILE* create_file(const std::filesystem::path& file) { return std::fopen(file.c_str(), "wbx"); }

void replace_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    // Whoever owns the folder could replace what is write-protected, as Windows never does.
    if (::access(to.c_str(), W_OK) != 0 && errno != ENOENT) throw std::system_error(errno, std::generic_category());
    std::filesystem::rename(from, to);
}

std::optional<std::string> file_identity(const std::filesystem::path& file) {
    struct stat status{};
    return ::stat(file.c_str(), &status) == 0 ? std::optional(identity(status)) : std::nullopt;
}

std::string standard_output_identity() {
    struct stat status{};
    return ::fstat(STDOUT_FILENO, &status) == 0 && S_ISREG(status.st_mode) ? identity(status) : "";
}

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) != 0; }

std::string text_of(const std::filesystem::path& path) { return path.string(); }
std::string_view never_in_names() { return "/"; }
std::vector<std::filesystem::path> drives() { return {}; }

// Without the C library's UTF-8 of a to z only.
std::string in_lower_case(const std::string& text) {
    static const locale_t utf8 = [] {
        const locale_t found = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
        return found ? found : ::newlocale(LC_CTYPE_MASK, "UTF-8", nullptr);  // as a Mac calls it
    }();
    const locale_t before = utf8 ? ::uselocale(utf8) : nullptr;
    std::string small;
    for (std::size_t at = 0; at < text.size();) {
        wchar_t letter = 0;
        std::array<char, MB_LEN_MAX> bytes{};
        std::mbstate_t in{}, out{};
        const std::size_t length = std::mbrtowc(&letter, text.data() + at, text.size() - at, &in);
        const bool valid = length > 0 && length <= text.size() - at;
        const auto lower = static_cast<wchar_t>(std::towlower(static_cast<wint_t>(letter)));
        const std::size_t written = valid ? std::wcrtomb(bytes.data(), lower, &out) : bytes.size() + 1;
        if (written <= bytes.size())
            small.append(bytes.data(), written);
        else
            small += text[at];
        at += valid ? length : 1;
    }
    if (utf8) ::uselocale(before);
    return small;
}

std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) || std::string_view("_-+=.,/:@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return text;
    std::string word = "'";
    for (const char c : text)
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    return word + "'";
}

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::size_t kLarge = std::size_t{2} << 20;
    std::size_t space = bytes;
    if (std::align(kLarge, kLarge, begin, space)) ::madvise(begin, space, MADV_HUGEPAGE);
#endif
}

void prefer_large_pages_from_now_on() {
#ifdef __GLIBC__
    // Up to the first threshold memory comes from the heap, which up to the second is kept as it is: what it is told once holds.
    constexpr int kMostOfOne = 32 << 20;  // that can be set
    ::mallopt(M_MMAP_THRESHOLD, kMostOfOne);
    ::mallopt(M_TRIM_THRESHOLD, 16 * kMostOfOne);
    constexpr std::size_t kEach = kMostOfOne - (1 << 20);
    std::vector<std::unique_ptr<void, decltype(&std::free)>> room;
    for (int i = 0; i < 4; ++i) {
        room.emplace_back(std::malloc(kEach), std::free);
        if (room.back()) prefer_large_pages(room.back().get(), kEach);
    }
#endif
}

}  // namespace normalscope

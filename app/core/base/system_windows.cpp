#include "core/base/system.h"
#include "core/base/windows_text.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// After it, whose types it needs.
#include <shellapi.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

namespace normalscope {

namespace {

HANDLE handle_of(std::FILE* stream) { return reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(stream))); }

std::string identity(HANDLE file) {
    BY_HANDLE_FILE_INFORMATION about{};
    if (::GetFileType(file) != FILE_TYPE_DISK || !::GetFileInformationByHandle(file, &about)) return "";
    return std::to_string(about.dwVolumeSerialNumber) + ":" + std::to_string(about.nFileIndexHigh) + ":" +
           std::to_string(about.nFileIndexLow);
}

}  // namespace

std::wstring wide(std::string_view utf8) {
    const int from = static_cast<int>(utf8.size());
    std::wstring text(static_cast<std::size_t>(::MultiByteToWideChar(CP_UTF8, 0, utf8.data(), from, nullptr, 0)), L' ');
    ::MultiByteToWideChar(CP_UTF8, 0, utf8.data(), from, text.data(), static_cast<int>(text.size()));
    return text;
}

std::string narrow(std::wstring_view utf16) {
    const int from = static_cast<int>(utf16.size());
    std::string text(
        static_cast<std::size_t>(::WideCharToMultiByte(CP_UTF8, 0, utf16.data(), from, nullptr, 0, nullptr, nullptr)),
        ' ');
    ::WideCharToMultiByte(CP_UTF8, 0, utf16.data(), from, text.data(), static_cast<int>(text.size()), nullptr, nullptr);
    return text;
}

void begin_process(int& argc, char**& argv) {
    for (std::FILE* stream : {stdin, stdout, stderr}) ::_setmode(::_fileno(stream), _O_BINARY);
    ::SetConsoleOutputCP(CP_UTF8);
    ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);  // a crash is told of by a line, not by a dialog

    // Kept as long as the program runs.
    static std::vector<std::string> arguments;
    static std::vector<char*> pointers;
    if (wchar_t** const words = ::CommandLineToArgvW(::GetCommandLineW(), &argc)) {
        for (int i = 0; i < argc; ++i) arguments.push_back(narrow(words[i]));
        ::LocalFree(static_cast<HLOCAL>(words));
    }
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    argc = static_cast<int>(arguments.size());
    argv = pointers.data();
}

int process_id() { return static_cast<int>(::GetCurrentProcessId()); }

bool process_runs(int id) {
    const HANDLE process = ::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(id));
    if (!process) return ::GetLastError() == ERROR_ACCESS_DENIED;
    const bool runs = ::WaitForSingleObject(process, 0) == WAIT_TIMEOUT;
    ::CloseHandle(process);
    return runs;
}

std::string host_name() {
    std::array<wchar_t, 256> name{};
    DWORD size = static_cast<DWORD>(name.size());
    return ::GetComputerNameExW(ComputerNameDnsHostname, name.data(), &size) ? narrow(name.data()) : "";
}

std::string variable(const char* name) {
    const std::wstring key = wide(name);
    std::wstring value(::GetEnvironmentVariableW(key.c_str(), nullptr, 0), L' ');
    value.resize(::GetEnvironmentVariableW(key.c_str(), value.data(), static_cast<DWORD>(value.size())));
    return narrow(value);
}

void set_variable(const char* name, const std::optional<std::string>& value) {
    ::_wputenv_s(wide(name).c_str(), value ? wide(*value).c_str() : L"");
}

std::filesystem::path home_folder() { return variable("USERPROFILE"); }

std::FILE* open_file(const std::filesystem::path& file, const char* mode) {
    return ::_wfopen(file.c_str(), wide(mode).c_str());
}

std::FILE* create_file(const std::filesystem::path& file) {
    const int number = ::_wopen(file.c_str(), _O_CREAT | _O_EXCL | _O_BINARY | _O_WRONLY, _S_IREAD | _S_IWRITE);
    return number < 0 ? nullptr : ::_fdopen(number, "wb");
}

// A scanner for viruses, or what indexes files, opens each new one for a moment.
void replace_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    constexpr DWORD kPause = 20, kLongest = 1000;  // milliseconds
    for (DWORD waited = 0; !::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING); waited += kPause) {
        const DWORD error = ::GetLastError();
        if (waited >= kLongest || (error != ERROR_ACCESS_DENIED && error != ERROR_SHARING_VIOLATION))
            throw std::system_error(static_cast<int>(error), std::system_category());
        ::Sleep(kPause);
    }
}

std::optional<std::string> file_identity(const std::filesystem::path& file) {
    const HANDLE opened = ::CreateFileW(file.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                        nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (opened == INVALID_HANDLE_VALUE) return std::nullopt;
    std::string found = identity(opened);
    ::CloseHandle(opened);
    return found;
}

std::string standard_output_identity() { return identity(handle_of(stdout)); }
bool is_terminal(std::FILE* stream) { return ::_isatty(::_fileno(stream)) != 0; }
std::string text_of(const std::filesystem::path& path) { return narrow(path.native()); }
std::string_view never_in_names() { return "/\\:*?\"<>|"; }

std::vector<std::filesystem::path> drives() {
    std::vector<std::filesystem::path> found;
    const DWORD present = ::GetLogicalDrives();
    for (int i = 0; i < 26; ++i)
        if ((present >> i & 1U) != 0) found.emplace_back(std::string(1, static_cast<char>('A' + i)) + ":\\");
    return found;
}

std::string in_lower_case(const std::string& text) {
    std::wstring letters = wide(text);
    ::CharLowerBuffW(letters.data(), static_cast<DWORD>(letters.size()));
    return narrow(letters);
}

// In double quotes, which both cmd and PowerShell take. To write a double quote within them takes a backslash for the program,
// and a second quote for PowerShell.
std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return (c < 0x80 && std::isalnum(c)) ||
               std::string_view("_-+=./:\\").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return text;
    std::string word = "\"";
    for (const char c : text) word += c == '"' ? "\\\"\"" : std::string(1, c);
    return word + (text.ends_with('\\') ? "\\\"" : "\"");
}

void prefer_large_pages(void*, std::size_t) {}
void prefer_large_pages_from_now_on() {}

}  // namespace normalscope

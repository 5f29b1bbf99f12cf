#include "batch/other_program.h"

#include "core/base/system.h"
#include "core/base/windows_text.h"

#include <windows.h>

#include <sstream>

namespace normalscope {

namespace {

// As CommandLineToArgvW reads it: in quotes, within which a backslash counts only before one.
std::wstring quoted(const std::wstring& word) {
    std::wstring text = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t c : word) {
        if (c == L'"') text.append(backslashes + 1, L'\\');
        backslashes = c == L'\\' ? backslashes + 1 : 0;
        text += c;
    }
    return text.append(backslashes, L'\\') + L"\"";
}

}  // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
    std::istringstream folders(variable("PATH"));
    for (std::string folder; std::getline(folders, folder, ';');) {
        std::error_code ignored;
        std::filesystem::path program = std::filesystem::path(folder) / (name + ".exe");
        if (std::filesystem::is_regular_file(program, ignored)) return program;
    }
    return std::nullopt;
}

OtherProgram::OtherProgram(const std::vector<std::string>& command, const std::filesystem::path& log) {
    std::wstring line;
    for (const std::string& word : command) line += (line.empty() ? L"" : L" ") + quoted(wide(word));
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    const HANDLE out = ::CreateFileW(log.c_str(), GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited,
                                     CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
    STARTUPINFOW startup{};
    startup.cb = sizeof startup;
    startup.dwFlags = STARTF_USESTDHANDLES;
    startup.hStdOutput = startup.hStdError = out;
    PROCESS_INFORMATION process{};
    if (::CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, CREATE_NEW_PROCESS_GROUP | CREATE_NO_WINDOW,
                         nullptr, nullptr, &startup, &process)) {
        ::CloseHandle(process.hThread);
        process_ = reinterpret_cast<std::intptr_t>(process.hProcess);
    }
    ::CloseHandle(out);
}

OtherProgram::~OtherProgram() {
    if (process_ == -1) return;
    const HANDLE process = reinterpret_cast<HANDLE>(process_);
    ::TerminateProcess(process, 1);
    ::WaitForSingleObject(process, INFINITE);
    ::CloseHandle(process);
}

std::optional<int> OtherProgram::ended_within(int milliseconds) {
    const HANDLE process = reinterpret_cast<HANDLE>(process_);
    if (process_ == -1) return -1;
    if (::WaitForSingleObject(process, static_cast<DWORD>(milliseconds)) == WAIT_TIMEOUT) return std::nullopt;
    DWORD code = 0;
    const bool known = ::GetExitCodeProcess(process, &code);
    ::CloseHandle(process);
    process_ = -1;
    return known ? static_cast<int>(code) : -1;
}

}  // namespace normalscope

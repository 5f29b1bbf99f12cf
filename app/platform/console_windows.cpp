#include "platform/console.h"

#include "core/base/windows_text.h"

#include <windows.h>

#include <array>
#include <cstdio>

namespace normalscope {

namespace {

// A console that ends with this program, so that nobody can read what is in it then.
bool has_own_console() {
    std::array<DWORD, 2> processes{};
    return ::GetConsoleProcessList(processes.data(), static_cast<DWORD>(processes.size())) == 1;
}

bool somebody_reads_errors() { return ::GetFileType(::GetStdHandle(STD_ERROR_HANDLE)) != FILE_TYPE_UNKNOWN; }

}  // namespace

void leave_own_console() {
    if (!has_own_console()) return;
    ::ShowWindow(::GetConsoleWindow(), SW_HIDE);
    ::FreeConsole();
}

void tell_error(const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
    std::fflush(stderr);
    if (has_own_console() || !somebody_reads_errors())
        ::MessageBoxW(nullptr, wide(line).c_str(), L"Normalscope", MB_OK | MB_ICONERROR);
}

}  // namespace normalscope

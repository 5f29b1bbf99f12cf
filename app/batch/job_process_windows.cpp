#include "batch/job_process.h"

#include "core/base/file.h"
#include "core/base/system.h"
#include "core/base/windows_text.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <thread>

namespace normalscope {

namespace {

constexpr const char* kSeat = "NORMALSCOPE_JOB";  // "JOB PIPE STOP WORD": set for a process that is started anew

HANDLE handle(std::intptr_t number) { return reinterpret_cast<HANDLE>(number); }
std::intptr_t number(HANDLE handle) { return reinterpret_cast<std::intptr_t>(handle); }
void keep_to_oneself(HANDLE handle) { ::SetHandleInformation(handle, HANDLE_FLAG_INHERIT, 0); }

struct Ends {
    HANDLE read = nullptr, write = nullptr;
};
Ends inheritable_pipe(std::size_t room) {
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    Ends ends;
    ::CreatePipe(&ends.read, &ends.write, &inherited, static_cast<DWORD>(room));
    return ends;
}

// What this process has read on its standard input, for another one to read it there.
HANDLE standard_input_again() {
    const std::string& text = standard_input_so_far();
    const Ends ends = inheritable_pipe(text.size() + 1);
    DWORD written = 0;
    keep_to_oneself(ends.write);
    ::WriteFile(ends.write, text.data(), static_cast<DWORD>(text.size()), &written, nullptr);
    ::CloseHandle(ends.write);
    return ends.read;
}

bool start_anew(HANDLE input, PROCESS_INFORMATION& process) {
    const std::filesystem::path program = program_file();
    std::wstring line = ::GetCommandLineW();
    STARTUPINFOW startup{};
    startup.cb = sizeof startup;
    startup.dwFlags = STARTF_USESTDHANDLES;
    startup.hStdInput = input;
    startup.hStdError = ::GetStdHandle(STD_ERROR_HANDLE);
    ::SetHandleInformation(startup.hStdError, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
    return ::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &startup,
                            &process);
}

std::optional<JobSeat> seat_of(const std::string& text) {
    std::istringstream words(text);
    JobSeat seat;
    std::intptr_t pipe = 0, stop_sign = 0;
    if (!(words >> seat.job >> pipe >> stop_sign)) return std::nullopt;
    std::getline(words >> std::ws, seat.word);
    set_variable(kSeat, std::nullopt);
    seat.pipe = ::_open_osfhandle(pipe, _O_BINARY);
    std::thread([stop = handle(stop_sign)] {
        if (::WaitForSingleObject(stop, INFINITE) == WAIT_OBJECT_0) std::raise(SIGTERM);
    }).detach();
    return seat;
}

}  // namespace

std::string JobProcess::end() {
    ::_close(pipe);
    pipe = -1;
    DWORD code = 0;
    ::WaitForSingleObject(handle(process), INFINITE);
    ::GetExitCodeProcess(handle(process), &code);
    ::CloseHandle(handle(process));
    ::CloseHandle(handle(stop_sign));
    constexpr DWORD kFirstOfCrashes = 0xC0000000;
    if (code < kFirstOfCrashes) return code != 0 ? "ended" : "";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "crashed (%08lX)", code);
    return text.data();
}

void JobProcess::stop() const { ::SetEvent(handle(stop_sign)); }

std::optional<JobProcess> start_job(std::size_t job, const std::string& word) {
    const Ends ends = inheritable_pipe(0);
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    const HANDLE stop = ::CreateEventW(&inherited, TRUE, FALSE, nullptr);
    const HANDLE input = standard_input_again();
    keep_to_oneself(ends.read);
    set_variable(kSeat, std::to_string(job) + " " + std::to_string(number(ends.write)) + " " +
                            std::to_string(number(stop)) + " " + word);
    PROCESS_INFORMATION process{};
    const bool started = start_anew(input, process);
    set_variable(kSeat, std::nullopt);
    ::CloseHandle(input);
    ::CloseHandle(ends.write);
    keep_to_oneself(stop);
    if (!started) return std::nullopt;
    ::CloseHandle(process.hThread);
    return JobProcess{.process = number(process.hProcess),
                      .stop_sign = number(stop),
                      .pipe = ::_open_osfhandle(number(ends.read), _O_BINARY)};
}

const std::optional<JobSeat>& own_seat() {
    static const std::optional<JobSeat> seat = seat_of(variable(kSeat));
    return seat;
}

// A pipe cannot be waited for there: each is asked in turn.
std::vector<bool> wait_for_any(std::span<const JobProcess> jobs) {
    constexpr DWORD kPause = 5, kLongest = 200;  // milliseconds
    std::vector<bool> has_news(jobs.size());
    for (DWORD waited = 0; waited < kLongest && std::ranges::count(has_news, true) == 0; waited += kPause) {
        if (waited > 0) ::Sleep(kPause);
        for (std::size_t j = 0; j < jobs.size(); ++j) {
            DWORD waiting = 0;
            has_news[j] = jobs[j].pipe >= 0 && (!::PeekNamedPipe(handle(::_get_osfhandle(jobs[j].pipe)), nullptr, 0,
                                                                 nullptr, &waiting, nullptr) ||
                                                waiting > 0);
        }
    }
    return has_news;
}

}  // namespace normalscope

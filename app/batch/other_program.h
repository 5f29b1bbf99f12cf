#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// The program of that name in one of PATH's folders.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Another program, which runs beside this one, and not longer.
class OtherProgram {
public:
    /// `command` begins with its file. What it writes goes to `log`. Ctrl+C is not for it.
    OtherProgram(const std::vector<std::string>& command, const std::filesystem::path& log);
    ~OtherProgram();
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;

    /// Its exit code if it ends within that time, in milliseconds; -1 where it could not be started, or died.
    std::optional<int> ended_within(int milliseconds);

private:
    std::intptr_t process_ = -1;
};

}  // namespace normalscope

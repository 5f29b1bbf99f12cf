#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>

namespace normalscope {

/// Looks now and then whether somebody has written to a file: by when it was, and how large it is.
class FileWatch {
public:
    /// Seconds between two looks.
    static constexpr double kEvery = 0.5;

    /// From now on this file, as it is.
    void begin(const std::filesystem::path& file, double now) {
        file_ = file;
        known_ = seen_ = stamp();
        due_ = now + kEvery;
    }
    double due() const { return due_; }
    /// Whether it is another since it was begun, or since this was last said; not while it is still being written, nor while
    /// there is none.
    bool changed(double now) {
        if (now < due_) return false;
        due_ = now + kEvery;
        const std::optional<Stamp> before = seen_;
        seen_ = stamp();
        if (!seen_ || seen_ != before || seen_ == known_) return false;
        known_ = seen_;
        return true;
    }
    const std::filesystem::path& file() const { return file_; }

private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    std::optional<Stamp> stamp() const {
        std::error_code error;
        if (!std::filesystem::is_regular_file(file_, error)) return std::nullopt;
        const Stamp now{std::filesystem::last_write_time(file_, error), std::filesystem::file_size(file_, error)};
        return error ? std::nullopt : std::optional(now);
    }

    std::filesystem::path file_;
    std::optional<Stamp> known_, seen_;
    double due_ = 0.0;
};

}  // namespace normalscope

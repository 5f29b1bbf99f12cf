#pragma once

#include <stdexcept>
#include <string>

namespace normalscope {

/// What the user gave cannot be used: a file, a scene, an option's value. Its text is one line that names the
/// thing, the reason and, where there is one, the remedy. `main` turns each kind into its exit code.
struct Error : std::runtime_error {
    explicit Error(const std::string& line) : Error("", line) {}
    /// "SUBJECT: REASON", or the reason alone of what has no name; in one line, whatever the two hold.
    Error(const std::string& subject, const std::string& reason_alone);

    /// For whoever knows a better name for the thing.
    std::string reason;
};

/// The command line itself is wrong (exit code 2).
struct UsageError : Error {
    using Error::Error;
};

/// An input could not be read or is not valid, or an output could not be written (exit code 3).
struct InputError : Error {
    using Error::Error;
};

/// No graphics context could be made (exit code 4).
struct ContextError : Error {
    using Error::Error;
};

/// What to say of std::bad_alloc.
inline constexpr const char* kOutOfMemory = "out of memory; a smaller --size and fewer --jobs need less";

}  // namespace normalscope

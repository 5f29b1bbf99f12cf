#include "core/base/output.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace normalscope {

void print(std::string_view bytes) {
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0) {
        const int error = errno;
        std::clearerr(stdout);
        throw InputError("standard output: cannot be written: " + std::string(std::strerror(error)));
    }
}

void write(const Output& to, std::string_view bytes) {
    if (to.is_standard())
        print(bytes);
    else
        write_file(to.file, bytes);
}

}  // namespace normalscope

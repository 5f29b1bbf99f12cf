#include "core/base/temporary_folder.h"

#include "core/base/error.h"

#include <unistd.h>

namespace normalscope {

TemporaryFolder::TemporaryFolder(const std::filesystem::path& beside)
    : path_(beside.string() + ".part" + std::to_string(::getpid())) {
    std::error_code error;
    std::filesystem::create_directories(path_, error);
    if (error) throw InputError(path_.string() + ": cannot be made: " + error.message());
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace normalscope

#include "core/base/temporary_folder.h"

#include "core/base/error.h"

#include <random>
#include <string>
#include <system_error>

namespace normalscope {

// With a name that nobody else has: two runs may write the same file, from two containers that share its folder.
TemporaryFolder::TemporaryFolder(const std::filesystem::path& beside) {
    std::error_code error;  // of making the folder around it: making it will say what is wrong
    if (beside.has_parent_path()) std::filesystem::create_directories(beside.parent_path(), error);
    std::random_device random;
    do {
        path_ = beside;
        path_ += ".part-" + std::to_string(random());
    } while (!std::filesystem::create_directory(path_, error) && !error);
    if (error)
        throw InputError(beside.string() + ": cannot be written: no folder can be made beside it: " + error.message());
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, error);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace normalscope

#include "core/base/temporary_folder.h"

#include "core/base/error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace normalscope {

// With a name that nobody else has: two runs may write the same file, from two containers that share its folder.
TemporaryFolder::TemporaryFolder(const std::filesystem::path& beside) {
    std::string name = beside.string() + ".part-XXXXXX";
    std::error_code ignored;  // making it will say what is wrong
    if (beside.has_parent_path()) std::filesystem::create_directories(beside.parent_path(), ignored);
    if (!::mkdtemp(name.data()))
        throw InputError(beside.string() +
                         ": cannot be written: no folder can be made beside it: " + std::strerror(errno));
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace normalscope

#include "core/base/links.h"

#include <system_error>

namespace normalscope {

std::filesystem::path without_links(const std::filesystem::path& file) {
    constexpr int kMostLinks = 40;  // as Linux has it; then they lead in a circle
    std::filesystem::path end = file;
    std::error_code error;
    for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(end, error); ++i) {
        const std::filesystem::path target = std::filesystem::read_symlink(end, error);
        if (error) break;
        end = end.parent_path() / target;  // which is the target alone where that begins at the root
    }
    return end;
}

}  // namespace normalscope

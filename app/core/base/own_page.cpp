#include "core/base/own_page.h"

#include "core/base/system.h"

namespace normalscope {

// Beside the program, as Windows' archive has it; where it is installed; in a Mac's bundle; where it was built.
std::filesystem::path own_page() {
    const std::filesystem::path folder = program_file().parent_path();
    for (const char* where : {".", "../share/normalscope", "../Resources", "web", "../web"}) {
        std::error_code ignored;
        std::filesystem::path page = (folder / where / "normalscope.html").lexically_normal();
        if (!folder.empty() && std::filesystem::exists(page, ignored)) return page;
    }
    return {};
}

}  // namespace normalscope

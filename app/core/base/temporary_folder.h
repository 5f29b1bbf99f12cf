#pragma once

#include <filesystem>
#include <string>

namespace normalscope {

/// A folder beside the file that will be made from what is in it; gone, with all of that, once it is no longer needed.
class TemporaryFolder {
public:
    explicit TemporaryFolder(const std::filesystem::path& beside);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace normalscope

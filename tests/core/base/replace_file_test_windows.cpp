#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/temporary_folder.h"

#include <gtest/gtest.h>

#include <windows.h>

#include <chrono>
#include <iterator>
#include <thread>

namespace normalscope {
namespace {

// As a scanner for viruses opens what has just been written: nobody else may have it meanwhile.
HANDLE held(const std::filesystem::path& file) {
    return ::CreateFileW(file.c_str(), GENERIC_READ, 0, nullptr, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
}

TEST(ReplaceFile, WaitsForWhoeverHoldsTheFile) {
    const TemporaryFolder folder(std::filesystem::path(testing::TempDir()) / "normalscope-replace");
    const std::filesystem::path file = folder.path() / "a";
    write_file(file, "old");
    const HANDLE handle = held(file);
    ASSERT_NE(handle, INVALID_HANDLE_VALUE);
    std::thread scanner([handle] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        ::CloseHandle(handle);
    });
    EXPECT_NO_THROW(write_file(file, "new"));
    scanner.join();
    EXPECT_EQ(read_file(file, 100), "new");
}

TEST(ReplaceFile, GivesUpAfterASecond) {
    const TemporaryFolder folder(std::filesystem::path(testing::TempDir()) / "normalscope-replace");
    const std::filesystem::path file = folder.path() / "a";
    write_file(file, "old");
    const HANDLE handle = held(file);
    EXPECT_THROW(write_file(file, "new"), InputError);
    ::CloseHandle(handle);
    EXPECT_EQ(read_file(file, 100), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "nothing is left beside it";
}

}  // namespace
}  // namespace normalscope

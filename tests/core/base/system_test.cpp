#include "core/base/system.h"
#include "core/base/file.h"
#include "core/base/temporary_folder.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <memory>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

// Of two, three and four bytes, and from the right to the left.
const std::string kName = "räume-面-😀-عين";

TEST(System, APathTakesTextToBeUtf8) {
    const fs::path path = kName + ".json";
    EXPECT_TRUE(path.u8string() == u8"räume-面-😀-عين.json");
    EXPECT_EQ(text_of(path), kName + ".json");
    EXPECT_EQ(path.string(), kName + ".json");
    EXPECT_EQ(text_of(fs::path("a") / kName).substr(2), kName);
}

TEST(System, AFileOfAnyNameIsWrittenFoundAndRead) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / kName);
    const fs::path file = folder.path() / (kName + ".txt");
    write_file(file, "one\r\ntwo\n\x1a three");
    EXPECT_EQ(read_file(file, 1000), "one\r\ntwo\n\x1a three");
    write_file(file, "another");
    EXPECT_EQ(read_file(file, 1000), "another");
    EXPECT_EQ(text_of(fs::directory_iterator(folder.path())->path().filename()), kName + ".txt");
}

TEST(System, WhatIsThereIsNotCreatedAgain) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "normalscope-system");
    const fs::path file = folder.path() / "a";
    write_file(file, "");
    errno = 0;
    EXPECT_EQ(create_file(file), nullptr);
    EXPECT_EQ(errno, EEXIST);
}

TEST(System, AFileIsTheSameByAnyName) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "normalscope-system");
    write_file(folder.path() / "a", "");
    write_file(folder.path() / "b", "");
    const auto a = file_identity(folder.path() / "a");
    ASSERT_TRUE(a.has_value());
    EXPECT_FALSE(a->empty());
    EXPECT_EQ(a, file_identity(folder.path() / "." / "a"));
    EXPECT_NE(a, file_identity(folder.path() / "b"));
    EXPECT_EQ(file_identity(folder.path()), file_identity(folder.path() / "."));
    EXPECT_EQ(file_identity(folder.path() / "c"), std::nullopt);
}

TEST(System, LettersOfAnyAlphabetHaveACase) {
    EXPECT_EQ(in_lower_case("ÄÖÜ-ΑΒΓ-ЖЗ-A"), "äöü-αβγ-жз-a");
    EXPECT_EQ(in_lower_case(kName), kName);
}

TEST(System, ThisProcessRuns) {
    EXPECT_GT(process_id(), 0);
    EXPECT_TRUE(process_runs(process_id()));
}

TEST(System, VariablesAreUtf8) {
    set_variable("NORMALSCOPE_TEST", kName);
    EXPECT_EQ(variable("NORMALSCOPE_TEST"), kName);
    set_variable("NORMALSCOPE_TEST", std::nullopt);
    EXPECT_EQ(variable("NORMALSCOPE_TEST"), "");
}

}  // namespace
}  // namespace normalscope

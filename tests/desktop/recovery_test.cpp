#include "desktop/recovery.h"
#include "core/base/file.h"
#include "core/base/temporary_folder.h"
#include "core/scene/scene_json.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

TEST(Recovery, OffersOnceWhatAProcessThatIsGoneHasLeft) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    const Recovery recovery(folder.path());
    Scene scene;
    scene.rule = Rule::Cofactor;
    if (const pid_t child = ::fork(); child == 0) {
        recovery.keep(scene_text(scene));
        ::_exit(0);  // as if killed
    } else {
        ::waitpid(child, nullptr, 0);
    }
    EXPECT_EQ(recovery.left_behind(), scene);
    EXPECT_EQ(recovery.left_behind(), std::nullopt);
}

TEST(Recovery, LeavesAloneWhatAnotherWindowKeeps) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    const Recovery recovery(folder.path());
    recovery.keep(scene_text(Scene{}));
    EXPECT_EQ(recovery.left_behind(), std::nullopt);  // this process runs
    EXPECT_FALSE(fs::is_empty(folder.path()));
    recovery.keep("");
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Recovery, WhatIsDamagedIsGone) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    write_file(folder.path() / "unsaved-2147483646.json", "{");
    write_file(folder.path() / "settings.json", "{}");
    EXPECT_EQ(Recovery(folder.path()).left_behind(), std::nullopt);
    EXPECT_FALSE(fs::exists(folder.path() / "unsaved-2147483646.json"));
    EXPECT_TRUE(fs::exists(folder.path() / "settings.json"));
    EXPECT_EQ(Recovery(std::nullopt).left_behind(), std::nullopt);
}

}  // namespace
}  // namespace normalscope

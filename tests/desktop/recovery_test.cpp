#include "desktop/recovery.h"
#include "core/base/file.h"
#include "core/base/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

// Has a process that is gone by now keep this.
void leave_behind(const fs::path& folder, const std::vector<UnsavedWork>& works) {
    if (const pid_t child = ::fork(); child == 0) {
        Recovery(folder).keep(unsaved_text(works));
        ::_exit(0);  // as if killed
    } else {
        ::waitpid(child, nullptr, 0);
    }
}

std::vector<UnsavedWork> two_works() {
    Scene scene;
    scene.rule = Rule::Cofactor;
    return {{"shear", scene}, {"", Scene{}}};
}

TEST(Recovery, OffersOnceWhatAProcessThatIsGoneHasLeft) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    leave_behind(folder.path(), two_works());
    Recovery recovery(folder.path());
    EXPECT_EQ(recovery.left_behind(), two_works());
    recovery.keep("");
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_EQ(Recovery(folder.path()).left_behind(), std::vector<UnsavedWork>{});
}

TEST(Recovery, OffersAllThatSeveralHaveLeft) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    leave_behind(folder.path(), two_works());
    leave_behind(folder.path(), {{"third", Scene{}}});
    const std::vector<UnsavedWork> found = Recovery(folder.path()).left_behind();
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found.back().file, "third") << "the newest is the last";
}

TEST(Recovery, WhatIsOfferedIsNotLostWhereTheProcessDiesBeforeTheAnswer) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    leave_behind(folder.path(), two_works());
    EXPECT_EQ(Recovery(folder.path()).left_behind(), two_works());
    EXPECT_EQ(Recovery(folder.path()).left_behind(), two_works());
}

TEST(Recovery, LeavesAloneWhatAnotherWindowKeeps) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    const std::string other = "unsaved-" + std::to_string(::getppid()) + ".json";  // which runs
    write_file(folder.path() / other, unsaved_text(two_works()));
    Recovery recovery(folder.path());
    EXPECT_EQ(recovery.left_behind(), std::vector<UnsavedWork>{});
    recovery.keep("");
    EXPECT_TRUE(fs::exists(folder.path() / other));
}

TEST(Recovery, TheNumberOfAProcessMayBeThatOfTheOneBefore) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    Recovery(folder.path()).keep(unsaved_text(two_works()));
    Recovery recovery(folder.path());
    EXPECT_EQ(recovery.left_behind(), two_works());
    recovery.keep(unsaved_text(two_works()));
    EXPECT_FALSE(fs::is_empty(folder.path()));
    recovery.keep("");
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Recovery, WhatIsDamagedIsGone) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "recovery");
    write_file(folder.path() / "unsaved-2147483646.json", "{");
    write_file(folder.path() / "settings.json", "{}");
    Recovery recovery(folder.path());
    EXPECT_EQ(recovery.left_behind(), std::vector<UnsavedWork>{});
    recovery.keep("");
    EXPECT_FALSE(fs::exists(folder.path() / "unsaved-2147483646.json"));
    EXPECT_TRUE(fs::exists(folder.path() / "settings.json"));
    EXPECT_EQ(Recovery(std::nullopt).left_behind(), std::vector<UnsavedWork>{});
}

}  // namespace
}  // namespace normalscope

#include "desktop/settings.h"
#include "core/base/temporary_folder.h"
#include "killed_while_saving.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

TEST(Settings, AKillInTheMiddleLeavesWholeSettings) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "normalscope-settings");
    ::setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
    std::array<Settings, 2> settings;
    for (std::size_t i = 0; i < 200; ++i)
        for (Settings& s : settings)
            s.remembered.lessons["lesson " + std::to_string(i)] = &s == settings.data() ? 1 : 22;
    EXPECT_EQ(killed_while_saving(folder.path() / "normalscope" / "settings.json",
                                  [&](int v) { save_settings(settings[static_cast<std::size_t>(v)]); }),
              2u);
    EXPECT_EQ(load_settings().remembered.lessons.size(), 200u);
}

TEST(Settings, AreReadAsTheyWereWritten) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "normalscope-settings");
    ::setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
    for (const bool maximised : {false, true}) {
        Settings settings;
        settings.place = {glm::ivec2(1000, 700), glm::ivec2(-30, 40), maximised};
        settings.monitor = "DP-1";
        settings.remembered.motion = maximised;
        save_settings(settings);
        EXPECT_EQ(load_settings().place, settings.place);
        EXPECT_EQ(load_settings().monitor, settings.monitor);
        EXPECT_EQ(load_settings().remembered.motion, settings.remembered.motion);
    }
}

}  // namespace
}  // namespace normalscope

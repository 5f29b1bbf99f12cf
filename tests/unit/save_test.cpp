#include "core/file.h"
#include "core/scene_file.h"
#include "core/scene_json.h"
#include "settings.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>
#include <set>
#include <thread>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

class SaveTest : public testing::Test {
protected:
    /// Saves the two versions in turn in another process, which is killed in the middle of it, again and again: the file
    /// must always be the one or the other. Gives how many of the two it was seen to be.
    std::size_t killed_while_saving(const fs::path& file, const std::function<void(int version)>& save) {
        std::array<std::string, 2> versions;
        for (const int v : {1, 0}) {
            save(v);
            versions[static_cast<std::size_t>(v)] = read_file(file, 1 << 26);
        }
        EXPECT_NE(versions[0], versions[1]);
        std::set<std::string> seen;
        std::mt19937 random(1);
        for (int round = 0; round < 50; ++round) {
            const pid_t child = ::fork();
            if (child == 0)
                for (int i = round + 1;; ++i) save(i % 2);
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 12'000));
            ::kill(child, SIGKILL);
            ::waitpid(child, nullptr, 0);
            const std::string found = read_file(file, 1 << 26);
            EXPECT_TRUE(found == versions[0] || found == versions[1])
                << "round " << round << ": " << found.size() << " bytes, and not those of a version";
            seen.insert(found);
        }
        return seen.size();
    }

    const TemporaryFolder temporary_{fs::path(testing::TempDir()) / "normalscope-save"};
    const fs::path& folder_ = temporary_.path();
};

TEST_F(SaveTest, AKillInTheMiddleLeavesAWholeScene) {
    const fs::path file = folder_ / "scene.json";
    std::array<std::string, 2> texts;
    for (std::size_t v : {0u, 1u}) {
        Scene scene;
        scene.about = std::string(v == 0 ? 2'000'000 : 3'000'000, v == 0 ? 'a' : 'b');  // takes a while to write
        texts[v] = scene_text(scene);
    }
    EXPECT_EQ(killed_while_saving(file, [&](int v) { write_file(file, texts[static_cast<std::size_t>(v)]); }), 2u);
    EXPECT_NO_THROW(load_scene(file.string()));
}

TEST_F(SaveTest, AKillInTheMiddleLeavesWholeSettings) {
    ::setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
    std::array<Settings, 2> settings;
    for (std::size_t i = 0; i < 200; ++i)
        for (Settings& s : settings) s.lessons["lesson " + std::to_string(i)] = &s == settings.data() ? 1 : 22;
    EXPECT_EQ(killed_while_saving(folder_ / "normalscope" / "settings.json",
                                  [&](int v) { save_settings(settings[static_cast<std::size_t>(v)]); }),
              2u);
    EXPECT_EQ(load_settings().lessons.size(), 200u);
}

}  // namespace
}  // namespace normalscope

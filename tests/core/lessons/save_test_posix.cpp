#include "core/base/temporary_folder.h"
#include "core/lessons/open.h"
#include "core/scene/scene_json.h"
#include "killed_while_saving.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

TEST(Save, AKillInTheMiddleLeavesAWholeScene) {
    const TemporaryFolder folder(fs::path(testing::TempDir()) / "normalscope-save");
    const fs::path file = folder.path() / "scene.json";
    std::array<std::string, 2> texts;
    for (std::size_t v : {0u, 1u}) {
        Scene scene;
        scene.about = std::string(v == 0 ? 2'000'000 : 3'000'000, v == 0 ? 'a' : 'b');  // takes a while to write
        texts[v] = scene_text(scene);
    }
    EXPECT_EQ(killed_while_saving(file, [&](int v) { write_file(file, texts[static_cast<std::size_t>(v)]); }), 2u);
    EXPECT_NO_THROW(load_scene(file.string()));
}

}  // namespace
}  // namespace normalscope

#include "core/lessons/link.h"

#include "core/base/error.h"
#include "core/lessons/address.h"
#include "core/lessons/lesson.h"
#include "core/lessons/open.h"
#include "random.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

Scene random_scene(Random& random) {
    Scene scene;
    scene.about = random.chance(0.3) ? "„x ½, y 2“\n\"quoted\"" : "";
    scene.surface = ShapeSurface{static_cast<Shape>(random.below(7)), 3 + random.below(100)};
    if (random.chance(0.2)) scene.surface = MeshSurface{"folder/ünïcode name.obj"};
    if (random.chance(0.2)) scene.surface = FormulaSurface{.formula = "x^2+a*y^2+z^2-1", .bound = random.uniform(1, 3)};
    scene.stack = random.stack(6);
    scene.rule = static_cast<Rule>(random.below(3));
    scene.mistake = static_cast<Mistake>(random.below(12));
    scene.camera.azimuth = random.uniform(-360, 360);
    scene.theme = static_cast<Theme>(random.below(4));
    if (random.chance(0.5)) scene.probe = Point<Object>{random.vector()};
    for (int n = random.below(5); n > 0; --n) scene.pinned.push_back({random.vector()});
    scene.show.polygon = random.chance(0.5);
    return scene;
}

TEST(Link, RoundTripsRandomScenes) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Scene scene = random_scene(random);
        const std::string link = link_of(scene);
        EXPECT_EQ(link.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.:"),
                  std::string::npos);
        EXPECT_EQ(scene_of_link(link), scene);
        EXPECT_EQ(load_scene("  " + link.substr(0, 40) + "\n" + link.substr(40) + "\n"), scene) << "as mail breaks it";
    }
}

// A changed link is refused, or still says the same (the last letter has bits to spare).
TEST(Link, SurvivesCorruption) {
    Random random(2);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const Scene scene = random_scene(random);
        std::string link = link_of(scene);
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(link.size())));
        switch (random.below(3)) {
            case 0: link.resize(at); break;
            case 1: link[at] = static_cast<char>(random.below(256)); break;
            default: link.erase(at, 1 + static_cast<std::size_t>(random.below(5)));
        }
        try {
            EXPECT_EQ(scene_of_link(link), scene) << link;
        } catch (const InputError& e) {
            EXPECT_TRUE(std::string(e.what()).starts_with("link: ")) << e.what();
            ++refused;
        }
    }
    EXPECT_GT(refused, 2900);
}

TEST(Link, TellsOfNewerVersions) {
    std::string link = link_of(Scene{});
    link.replace(link.find(":1."), 3, ":7.");
    try {
        (void)scene_of_link(link);
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("newer version"), std::string::npos);
    }
}

TEST(Link, StandsInAFrame) {
    EXPECT_NE(frame_html("https://x.org/a.html?present#shear", "A \"<b>\"")
                  .find("src=\"https://x.org/a.html?panel=0#shear\""),
              std::string::npos);
    const std::string html = frame_html(link_of(Scene{}), "A \"<b>\"");
    EXPECT_TRUE(html.starts_with("<iframe src=\"normalscope.html?panel=0#normalscope:1.")) << html;
    EXPECT_NE(html.find("title=\"A &quot;&lt;b&gt;&quot;\""), std::string::npos) << html;
}

// This one was made when links began: it must open for ever.
TEST(Link, OpensOldLinks) {
    const std::string old =
        "normalscope:1.Qq26AXjaXVHLbuMwDPwVQZe9uIGTrrOAb_2OIggYm7WEypKhh9M08L_vSHaNxR5skNRwZkg-pXV-"
        "JBM6N7Fsj5Wkm0tRtvJNhEmx50p8CUVm5l6Q7cVD9C7dDPetiIqFJT3jv3IIw2SrUtd2Zh9YRE82TC7wryBCzARp8n"
        "pQUVYyJP9BHVSfMijK8nKVxJvn4EyK2lnZnn8vAEfqPmX7DmxHBtj3-tBUp0NdHQ_1ZblsiCu09NpmkzEgShksNz8v"
        "ux9ojBotn_m1TIHKrPmO1AFr6IECee_uITukvBPUo-444IURP8rCDNshKtnWh-MJmR41oMdzDUfK3VcfGKCjkT0Vqm"
        "89ptzxWsO-ZMMzrZZPpfDt3AiGHEbyA8cybF1t32XJKnmF_3K9nJr_yBpgs64zzsO70bHsdb2Vxgba6BMDAH-y_cD9"
        "kOB2Ixf0dqMywlMOyoX40zF43f_E9IV1bDHuO7CN18mQ3ekn7257YhiAvTdEz7FT15WjOFj2Boz854x5mwa_1-ay_A"
        "VC5OHB";
    Scene then = load_scene("slide-scale");
    then.about = "A sphere, x halved and y doubled: the naive normals lean, the inverse transpose's stand upright";
    then.arrows.limit = 160;
    then.camera.zoom = 1.0;
    EXPECT_EQ(scene_of_link(old), then);
}

}  // namespace
}  // namespace normalscope

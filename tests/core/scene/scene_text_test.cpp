#include "random.h"

#include "core/base/error.h"
#include "core/scene/scene_json.h"
#include "core/scene/scene_patch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace normalscope {
namespace {

template <class E>
E any_of(Random& random, int count) {
    return static_cast<E>(random.below(count));
}

Scene random_scene(Random& random) {
    Scene s;
    s.about = std::string("\"about\\\n\u00E9 ") + std::to_string(random.below(100));
    if (random.chance(0.5))
        s.surface = ShapeSurface{any_of<Shape>(random, 7), 3 + random.below(510)};
    else
        s.surface = MeshSurface{"folder/a mesh.obj"};
    s.stack = random.stack(8);
    s.rule = any_of<Rule>(random, 3);
    s.view = any_of<ViewMode>(random, 4);
    for (int n = random.below(5); n > 0; --n) s.pinned.push_back({random.vector(2.0)});
    s.arrows = {
        any_of<ArrowPlacement>(random, 2), 1 + random.below(1000), random.uniform(0.001, 10.0), random.below(1000), {}};
    if (random.chance(0.5)) {
        s.arrows.show.emplace();
        for (int n = random.below(5); n > 0; --n) s.arrows.show->push_back(any_of<ArrowKind>(random, 4));
    }
    s.camera = {
        random.uniform(-400.0, 400.0), random.uniform(-90.0, 90.0), random.uniform(0.001, 1000.0), {random.vector()}};
    s.light = {random.uniform(-400.0, 400.0), random.uniform(-90.0, 90.0)};
    s.color = any_of<SurfaceColor>(random, 3);
    s.theme = any_of<Theme>(random, 2);
    for (bool Shown::* what : {&Shown::ghost, &Shown::grid, &Shown::axes, &Shown::tangent_plane, &Shown::probe,
                               &Shown::legend, &Shown::polygon, &Shown::sheets, &Shown::stretch_axes})
        s.show.*what = random.chance(0.5);
    if (random.chance(0.5)) s.probe = Point<Object>{random.vector()};
    return s;
}

TEST(SceneText, ReadsBackExactly) {
    Random random(21);
    for (int i = 0; i < 3000 && !HasFailure(); ++i) {
        const Scene scene = random_scene(random);
        EXPECT_EQ(parse_scene(scene_text(scene), "text"), scene) << scene_text(scene);
    }
}

TEST(ScenePatch, LeadsFromOneSceneToAnother) {
    Random random(23);
    for (int i = 0; i < 1000 && !HasFailure(); ++i) {
        const Scene from = random_scene(random);
        Scene to = random_scene(random);
        to.theme = from.theme;
        EXPECT_EQ(with_patch(from, patch_between(from, to), {}), to);
        EXPECT_TRUE(patch_between(from, from).empty());
    }
}

// Whatever becomes of the text: a scene or one line of error, and nothing else.
TEST(SceneText, SurvivesDamage) {
    Random random(22);
    const std::string alphabet = "{}[]\",:.-+0123456789eEnaulltrfs \\\n\xFF";
    int scenes = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string text = scene_text(random_scene(random));
        for (int n = 1 + random.below(3); n > 0; --n) {
            const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
            const auto with = static_cast<std::size_t>(random.below(static_cast<int>(alphabet.size())));
            if (random.chance(0.5))
                text[at] = alphabet[with];
            else
                text.erase(at, 1 + with);
        }
        try {
            parse_scene(text, "text");
            ++scenes;
        } catch (const InputError& e) {
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
        }
    }
    EXPECT_GT(scenes, 100);
}

}  // namespace
}  // namespace normalscope

// Where words stand in a picture.
#include "core/frame/label_room.h"

#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/scene/setting.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>
#include <glm/vector_relational.hpp>

#include <initializer_list>
#include <string>

namespace normalscope {
namespace {

Frame frame_with(std::initializer_list<std::string> settings) {
    Scene scene = load_scene(std::string(kDefaultScene));
    for (const std::string& setting : settings) scene = with_setting(scene, setting);
    SurfaceCache surfaces;
    return make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {1280, 720}}});
}

bool is_of_the_probe(const Label& label) { return label.text.find(" n") != std::string::npos; }

TEST(LabelRoom, WordsOfTheProbeStandBesideManyArrows) {
    for (const std::string resolution : {"40", "150"})
        for (const std::string shape : {"sphere", "torus"}) {
            Frame frame =
                frame_with({"surface.shape=" + shape, "surface.resolution=" + resolution, "arrows.limit=1000000"});
            Pane& pane = frame.panes.front();
            ASSERT_GT(frame.surface->arrows.size(), kFewArrows);
            const LabelRoom room(pane, 1.0);
            int words = 0;
            for (const Label& label : pane.labels) {
                if (!is_of_the_probe(label)) continue;
                ++words;
                const glm::dvec2 half = room.half_size(label.text, label.role), middle(label.pixel);
                EXPECT_LT(share_within(pane.outline, middle - half, middle + half), 0.05)
                    << label.text << " on a " << shape << " of " << resolution;
            }
            EXPECT_EQ(words, 2);
        }
}

TEST(LabelRoom, WordsStandBesideATitle) {
    // A probe on top, whose naive arrow ends beneath its half's title.
    Frame frame = frame_with(
        {"view=split", "surface.shape=torus", "surface.resolution=40", "arrows.limit=1000000", "arrows.length=0.15"});
    for (Pane& pane : frame.panes) {
        const LabelRoom room(pane, 1.0);
        for (const Label& word : pane.labels)
            for (const Label& title : pane.labels) {
                if (title.role != Label::Role::Title || word.role == Label::Role::Title) continue;
                const glm::dvec2 of_title = room.half_size(title.text, title.role),
                                 half = of_title + room.half_size(word.text, word.role);
                const glm::dvec2 middle = glm::dvec2(title.pixel) + glm::dvec2(0.0, 14.0 + of_title.y);
                const glm::dvec2 away = glm::abs(glm::dvec2(word.pixel) - middle);
                EXPECT_TRUE(away.x >= half.x || away.y >= half.y) << word.text << " under " << title.text;
            }
    }
}

}  // namespace
}  // namespace normalscope

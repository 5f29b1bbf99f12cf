#include "core/frame/frame.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/picture/picking.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

Frame frame_with(const std::optional<Highlight>& highlight) {
    SurfaceCache surfaces;
    const Scene scene = load_scene("slide-scale");
    return make_frame(scene, surfaces.get(scene), {.rect = {{100, 0}, {800, 600}}, .highlight = highlight});
}

TEST(Highlight, PointingAtASymbolAddsToThePicture) {
    const std::size_t solids = frame_with(std::nullopt).panes[0].solids.size();
    const std::size_t glow = frame_with(std::nullopt).panes[0].translucent.size();
    for (const Symbol symbol : {Symbol::NObject, Symbol::VObject, Symbol::NWorld, Symbol::VWorld, Symbol::M3}) {
        const Frame frame = frame_with(Highlight{.symbol = symbol});
        EXPECT_GT(frame.panes[0].solids.size(), solids) << name(symbol);
        EXPECT_GT(frame.panes[0].translucent.size(), glow) << name(symbol);
    }
    // 0 stands for the tangent plane, which is there anyway: it changes its colour.
    const auto color = [](const Frame& frame) { return frame.panes[0].translucent.front().color; };
    EXPECT_NE(color(frame_with(Highlight{.symbol = Symbol::Zero})), color(frame_with(std::nullopt)));
}

TEST(Highlight, AnArrowPointedAtIsFoundAgain) {
    const Frame frame = frame_with(std::nullopt);
    for (const SymbolArrow& arrow : frame.panes[0].symbols) {
        if (arrow.what.symbol == Symbol::M3) continue;  // drawn only when it is pointed at in the equations
        const glm::dvec3 tip = frame.panes[0].view.pixel({arrow.base + arrow.vector});
        EXPECT_EQ(highlight_at(frame, glm::dvec2(tip) + glm::dvec2(100, 0), 1.0), arrow.what)
            << name(arrow.what.symbol);
    }
    EXPECT_FALSE(highlight_at(frame, {110, 5}, 1.0));
    EXPECT_FALSE(highlight_at(frame, {50, 300}, 1.0)) << "outside the picture";
}

}  // namespace
}  // namespace normalscope

#include "ui/arrangement.h"

#include "ui/panel/drawer.h"
#include "ui/panel/panel_context.h"
#include "ui/scene_strip.h"

#include <algorithm>

namespace normalscope {

namespace {

// In a window hardly wider than what stands beside the picture, that covers part of it rather than all.
constexpr float kNarrowestPicture = 240.0f;  // beside panel and tab; else the panel makes room
constexpr float kLeastPicture = 120.0f;      // beside a tab
constexpr float kLowestPicture = 280.0f;     // below a sentence

// Where both leave hardly a picture, the tab that was opened is what one wants to see; closing it is one press.
bool has_room_for_panel(const Look& look, int width, int side) {
    return side == 0 ||
           width - static_cast<int>(look.px(kPanelWidth)) - side >= static_cast<int>(look.px(kNarrowestPicture));
}

PixelRect beside(const Look& look, glm::ivec2 framebuffer, const Arrangement& a) {
    if (a.drawer)
        return {{0, 0}, {framebuffer.x, std::max(framebuffer.y - drawer_height(look, framebuffer, a.panel), 1)}};
    const int panel = a.panel ? static_cast<int>(look.px(kPanelWidth)) : 0;
    const int left = framebuffer.x - panel >= panel / 4 ? panel : 0;
    const int right = framebuffer.x - left - a.side >= static_cast<int>(look.px(kLeastPicture)) ? a.side : 0;
    return {{left, 0}, {std::max(framebuffer.x - left - right, 1), framebuffer.y}};
}

}  // namespace

Arrangement arrange(const Look& look, glm::ivec2 framebuffer, const Claims& claims) {
    Arrangement a;
    if (claims.tab && !claims.exercising) a.side = std::min(static_cast<int>(look.px(*claims.tab)), framebuffer.x);
    const bool low = is_drawer(look, framebuffer);
    // Where words are below the picture, or another panel is over it, there is no room for a drawer.
    a.drawer = low && !claims.lecture && !claims.tab;
    a.panel = claims.panel && !claims.presenting && !claims.exercising &&
              (low ? a.drawer : has_room_for_panel(look, framebuffer.x, a.side));
    a.picture = beside(look, framebuffer, a);
    const auto strip = static_cast<int>(scene_strip_height(look, static_cast<float>(a.picture.size.x)));
    const bool covered = a.picture.origin.x + a.picture.size.x > framebuffer.x - a.side;  // by the tab
    a.strip = !claims.lecture && !covered && (a.drawer ? !a.panel : claims.panel) &&
              a.picture.size.y - strip >= static_cast<int>(look.px(kLowestPicture));
    if (a.strip) a.picture.origin.y = strip, a.picture.size.y -= strip;
    return a;
}

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"
#include "core/scene/scene.h"
#include "ui/kit/requests.h"
#include "ui/kit/style.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace normalscope {

/// What a tab beside the picture looks at.
struct SideContext {
    const Look& look;
    const Frame& frame;
    const Status& status;
};

/// One tab of the panel at the picture's right. It is drawn into a column that scrolls, as wide as
/// ImGui::GetContentRegionAvail says.
struct SideTab {
    std::string_view id;  ///< for Interface::show_tab
    const char* label;
    const char* about;
    bool at_first;  ///< it stands in the left panel's row before all are asked for
    std::function<void(Scene&, const SideContext&)> draw;    ///< empty: it has a window of its own, below the tabs
    std::function<void(Scene&, const SideContext&)> head{};  ///< above the column, and stands still
};

struct SideMemory {
    std::optional<std::size_t> open;  ///< the tab that is shown; empty: the picture has the room
};

/// Logical pixels.
inline constexpr float kSideWidth = 460.0f;
inline constexpr float kTabsHeight = 44.0f;  ///< of the row of tabs above

/// The tabs in one row, for the panel at the left: one press opens a tab, another gives the room back to the picture.
/// Those that a first look can do without are there where `all` is set, by a press of its own.
void side_buttons(const Look& look, std::span<const SideTab> tabs, SideMemory& memory, bool& all);

/// The open tab, at the right, as high as the window. `width` in physical pixels.
void draw_side_panel(Scene& scene, std::span<const SideTab> tabs, SideMemory& memory, const SideContext& context,
                     float width);

}  // namespace normalscope

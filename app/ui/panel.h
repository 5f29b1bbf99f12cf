#pragma once

#include "core/scene_file.h"
#include "core/scene_json.h"
#include "ui/file_dialog.h"
#include "ui/interface.h"
#include "ui/side_panel.h"
#include "ui/stack_section.h"
#include "ui/style.h"

#include <span>
#include <vector>

namespace normalscope {

/// What the panel's parts look at and act on.
struct PanelContext {
    const Look& look;
    const Frame& frame;
    const Status& status;
    Requests& requests;
    FileDialog& dialog;
    std::span<const SideTab> tabs;  ///< of the panel at the right
    SideMemory& side;
    bool& help;
};

struct PanelMemory;

/// Logical pixels.
inline constexpr float kPanelWidth = 388.0f;

/// The whole panel, at the left, as high as the window.
void draw_panel(Scene& scene, PanelMemory& memory, const PanelContext& context);

// Its parts, from top to bottom.
void toolbar(Scene& scene, PanelMemory& memory, const PanelContext& context);
void rule_buttons(Scene& scene, const PanelContext& context);
void mistake_chooser(Scene& scene, const PanelContext& context);
void view_buttons(Scene& scene, const PanelContext& context);
void probe_section(Scene& scene, PanelMemory& memory, const PanelContext& context);
void surface_section(Scene& scene, PanelMemory& memory, const PanelContext& context);
void slice_section(Scene& scene, const PanelContext& context);
void singular_section(Scene& scene, const PanelContext& context);
void arrows_section(Scene& scene, const PanelContext& context);
void picture_section(Scene& scene, const PanelContext& context);

}  // namespace normalscope

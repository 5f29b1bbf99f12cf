#pragma once

#include "ui/panel/panel_context.h"

namespace normalscope {

struct PanelMemory;

/// The whole panel, at the left, as high as the window.
void draw_panel(Scene& scene, PanelMemory& memory, const PanelContext& context);

// Its parts, from top to bottom.
void toolbar(Scene& scene, PanelMemory& memory, const PanelContext& context);
void rule_buttons(const Scene& scene, const PanelContext& context);
/// What stands in the naive rule's place: the rule itself, bent by a slider, or another mistake.
void naive_place(Scene& scene, const PanelContext& context);
void view_buttons(Scene& scene, const PanelContext& context);
void probe_section(Scene& scene, PanelMemory& memory, const PanelContext& context);
void surface_section(Scene& scene, PanelMemory& memory, const PanelContext& context);
void slice_section(Scene& scene, const PanelContext& context);
void singular_section(Scene& scene, const PanelContext& context);
void arrows_section(Scene& scene, const PanelContext& context);
void picture_section(Scene& scene, const PanelContext& context);

}  // namespace normalscope

#pragma once

#include "ui/panel/panel_context.h"

namespace normalscope {

struct PanelMemory;

/// The whole panel, at the left, as high as the window.
void draw_panel(Scene& scene, PanelMemory& memory, const PanelContext& context);

// Its parts, from top to bottom.
void toolbar(Scene& scene, PanelMemory& memory, const PanelContext& context);
/// Lessons with their progress, exercises, the gallery.
void learn_menu(const Scene& scene, PanelMemory& memory, const PanelContext& context);
/// The cofactor's rule is a first look's only where it is spoken of, or alone has the answer.
bool cofactor_in_sight(const Scene& scene, const PanelContext& context);
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

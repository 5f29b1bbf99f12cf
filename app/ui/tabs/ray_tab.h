#pragma once

#include "ui/kit/side_panel.h"

namespace normalscope {

/// What a ray tracer does with one ray, step by step.
void draw_ray_head(Scene& scene, const SideContext& context);
void draw_ray_tab(Scene& scene, const SideContext& context);

}  // namespace normalscope

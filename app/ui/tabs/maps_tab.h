#pragma once

#include "core/math/map_class.h"
#include "ui/kit/side_panel.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <vector>

namespace normalscope {

/// The classes of maps, until M changes.
struct MapsTab {
    std::optional<glm::dmat4> computed_of;
    int computed_rank = 3;
    std::vector<MapClassRow> rows;
    MapClaims claims;
};

void draw_maps_tab(const Scene& scene, MapsTab& tab, const SideContext& context);

}  // namespace normalscope

#pragma once

#include "core/surface/error_measures.h"
#include "core/surface/surface.h"
#include "ui/kit/side_panel.h"

#include <memory>
#include <optional>
#include <vector>

namespace normalscope {

/// What was measured, until the surface, M or the mistake changes.
struct ErrorTab {
    std::shared_ptr<const Surface> measured_on;  ///< held, so that no other surface can come to stand at its address
    std::optional<NormalMap> measured_map;
    glm::dmat4 measured_matrix{0.0};
    int measured_rank = -1;
    double measured_power = 1.0;
    std::optional<ErrorHistogram> histogram;
    std::optional<double> naive_worst;  ///< on this surface: of the naive rule itself, or bent to the scene's power
    std::vector<MeasuredError> family;  ///< with M's stretch varied
    std::vector<MeasuredError> powers;  ///< with the power varied
};

void draw_error_tab(const Scene& scene, ErrorTab& tab, const SideContext& context);

}  // namespace normalscope

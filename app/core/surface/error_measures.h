#pragma once

#include "core/math/normal_rules.h"
#include "core/mesh/mesh.h"
#include "core/scene/mistakes.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace normalscope {

/// How a rule's error is spread over a surface, by its area before M.
struct ErrorHistogram {
    double bin_degrees = 2.0;
    double most_degrees = 90.0;  ///< where the last bin ends: 180 where a mistake turns normals farther than 90°
    std::vector<double> shares;  ///< of the area, a bin; they add up to 1
    double worst_degrees = 0.0, mean_degrees = 0.0;
};
/// Of at most `most` normals, evenly picked, so that a large mesh does not slow down the dragging. Empty where M has no
/// inverse, or the surface has no normal.
std::optional<ErrorHistogram> error_histogram(const Mesh& mesh, const NormalMap& naive,
                                              const Transform<World, Object>& world_from_object,
                                              std::size_t most = 4000);

struct MeasuredError {
    double k = 1.0;        ///< σmax/σmin
    double power = 1.0;    ///< as in between_the_rules
    double degrees = 0.0;  ///< the worst that was met
};
/// The naive rule's worst error over directions all around, or that of between_the_rules in its place, for M3 with its
/// stretch made smaller and larger along the same axes: k from 1 to 100. From M3 = U Σ Vᵀ: the maps U Σᵗ Vᵀ; where M3
/// stretches evenly or not at all, some uneven stretch takes Σ's place.
std::vector<MeasuredError> measured_errors(const glm::dmat3& m3, double power = 1.0);
/// The same for M3 as it is, with powers from 1 to −1. Empty where M3 has no inverse.
std::vector<MeasuredError> measured_between_the_rules(const NormalMatrices& matrices);

}  // namespace normalscope

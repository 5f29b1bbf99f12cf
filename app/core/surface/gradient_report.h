#pragma once

#include "core/surface/surface.h"
#include "core/surface/surface_probe.h"

#include <optional>

namespace normalscope {

/// ∇f at the probe, and how near to it two other ways come: differences of f, and a polygon's cross product.
struct GradientReport {
    double f = 0.0;
    std::optional<glm::dvec3> gradient;  ///< empty where it does not exist
    double length = 0.0;                 ///< of the gradient, however large it is
    /// ∇f / |∇f|; empty where ∇f is zero but for rounding, or does not exist.
    std::optional<Normal<Object>> normal;

    struct Other {
        glm::dvec3 vector{0.0};
        std::optional<double> degrees_off;  ///< from the exact normal
        glm::dvec3 direction() const;       ///< of unit length; 0 for 0, and NaN for what is not finite
    };
    double step = 0.0;  ///< h in (f(x + h) − f(x − h)) / 2h
    Other differences;
    std::optional<Other> polygon;  ///< the unit normal of the polygonised surface's triangle there
};

/// Empty for a surface that comes from no formula.
std::optional<GradientReport> gradient_report(const Surface& surface, const Probe& probe);

}  // namespace normalscope

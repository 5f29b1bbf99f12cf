#pragma once

#include "core/math/space.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace normalscope {

/// A direction by two angles in degrees. At 0, 0 it is z.
template <class Space>
struct Direction {
    double azimuth = 0.0;    ///< about y, from z toward x
    double elevation = 0.0;  ///< toward y, −90 to 90

    /// Of unit length.
    Vector<Space> vector() const {
        const double a = glm::radians(azimuth), e = glm::radians(elevation);
        return {{std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)}};
    }
    friend bool operator==(const Direction&, const Direction&) = default;
};

}  // namespace normalscope

#include "core/math/projective.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace normalscope {

bool is_affine(const glm::dmat4& m) {
    return m[0].w == 0.0 && m[1].w == 0.0 && m[2].w == 0.0 && std::abs(m[3].w - 1.0) <= 1e-12;
}

glm::dmat4 with_unit_w(const glm::dmat4& m) {
    constexpr double kRounding = 1e-15;  // of s: what is left of 0 where a map and its inverse were multiplied
    const double s = m[3].w, most = std::max({std::abs(m[0].w), std::abs(m[1].w), std::abs(m[2].w)});
    if ((most == 0.0 && s == 1.0) || !(most <= kRounding * std::abs(s)) || s == 0.0) return m;
    glm::dmat4 result = m / s;
    for (int c = 0; c < 3; ++c) result[c].w = 0.0;
    result[3].w = 1.0;
    return result;
}

// Gauss's elimination with complete pivoting: what is left after so many steps is no larger than rounding.
int rank_of(const glm::dmat4& m) {
    std::array<std::array<double, 4>, 4> a{};
    for (std::size_t r = 0; r < 4; ++r) {
        const auto at = static_cast<glm::length_t>(r);
        for (std::size_t c = 0; c < 4; ++c) a[r][c] = m[static_cast<glm::length_t>(c)][at];
        // A translation by a million says nothing of a bottom row of thousandths.
        double largest = 0.0;
        for (const double v : a[r]) largest = std::max(largest, std::abs(v));
        if (largest > 0.0)
            for (double& v : a[r]) v /= largest;
    }
    constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
    for (std::size_t step = 0; step < 4; ++step) {
        std::size_t row = step, column = step;
        for (std::size_t r = step; r < 4; ++r)
            for (std::size_t c = step; c < 4; ++c)
                if (std::abs(a[r][c]) > std::abs(a[row][column])) row = r, column = c;
        if (!(std::abs(a[row][column]) > rounding)) return static_cast<int>(step);
        std::swap(a[step], a[row]);
        for (auto& r : a) std::swap(r[step], r[column]);
        for (std::size_t r = step + 1; r < 4; ++r) {
            const double by = a[r][step] / a[step][step];
            for (std::size_t c = step; c < 4; ++c) a[r][c] -= by * a[step][c];
        }
    }
    return 4;
}

std::optional<glm::dmat4> planes_by(const glm::dmat4& m) {
    if (rank_of(m) < 4) return std::nullopt;
    const glm::dmat4 inverse = glm::inverse(m);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(inverse[c][r])) return std::nullopt;
    return glm::transpose(inverse);
}

}  // namespace normalscope

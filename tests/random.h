#pragma once

#include "core/scene/scene.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <random>

namespace normalscope {

/// Random values from a fixed seed: a test that fails, fails again.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
    int below(int n) { return std::uniform_int_distribution(0, n - 1)(engine_); }
    bool chance(double p) { return uniform(0.0, 1.0) < p; }
    glm::dvec3 vector(double size = 1.0) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v = vector();
            if (const double l = glm::length(v); l > 0.1 && l < 1.0) return v / l;
        }
    }
    glm::dmat3 matrix(double size = 1.0) { return {vector(size), vector(size), vector(size)}; }

    /// One in twenty is singular.
    StackEntry entry() {
        switch (below(5)) {
            case 0: {
                glm::dvec3 factors(0.0);
                for (int i = 0; i < 3; ++i)
                    if (!chance(0.08)) factors[i] = (chance(0.3) ? -1.0 : 1.0) * uniform(0.1, 3.0);
                return Scale{factors};
            }
            case 1: return Rotate{direction(), chance(0.2) ? 90.0 * below(5) : uniform(-360.0, 360.0)};
            case 2: return Translate{vector(100.0)};
            case 3: {
                const glm::dvec3 a = vector(2.0);
                return Shear{.xy = a.x, .yz = a.y, .zx = a.z};
            }
            default: {
                glm::dmat4 m(matrix(2.0));
                m[3] = glm::dvec4(vector(10.0), 1.0);
                return Matrix{m};
            }
        }
    }
    std::vector<StackEntry> stack(int most) {
        std::vector<StackEntry> entries;
        for (int n = below(most + 1); n > 0; --n) entries.push_back(entry());
        return entries;
    }

private:
    std::mt19937_64 engine_;
};

/// The Frobenius norm: no vector grows by more.
inline double norm(const glm::dmat3& m) {
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

}  // namespace normalscope

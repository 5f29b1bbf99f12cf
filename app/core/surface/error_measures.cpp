#include "core/surface/error_measures.h"

#include "core/surface/surface.h"

#include <glm/exponential.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace normalscope {

namespace {

// Evenly spread over half the sphere, as −n is as far off as n: the golden angle's spiral.
std::vector<glm::dvec3> directions(std::size_t count) {
    std::vector<glm::dvec3> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(count), r = std::sqrt(1.0 - z * z);
        const double angle = static_cast<double>(i) * std::numbers::pi * (3.0 - std::sqrt(5.0));
        result[i] = {r * std::cos(angle), r * std::sin(angle), z};
    }
    return result;
}

double worst_error(const NormalMatrices& matrices, double power) {
    static const std::vector<glm::dvec3> kDirections = directions(500);
    const auto shown = between_the_rules(matrices, power);
    double worst = 0.0;
    if (shown && matrices.inverse_transpose)
        for (const glm::dvec3& n : kDirections)
            worst = std::max(worst, angle_degrees(*shown * n, *matrices.inverse_transpose * n).value_or(0.0));
    return worst;
}

}  // namespace

std::optional<ErrorHistogram> error_histogram(const Mesh& mesh, const NormalMap& naive,
                                              const Transform<World, Object>& world_from_object, std::size_t most) {
    const std::size_t step = std::max<std::size_t>(mesh.normals.size() / std::max<std::size_t>(most, 1), 1);
    ErrorHistogram histogram;
    std::array<double, 90> bins{};
    const std::vector<double> areas = vertex_areas(mesh);
    double sum = 0.0, area = 0.0;
    for (std::size_t i = 0; i < mesh.normals.size(); i += step) {
        const Normal<Object> n{mesh.normals[i]};
        const auto right = world_from_object(Point<Object>{mesh.positions[i]}, n);
        const auto error = right ? angle_degrees(naive(n).xyz, right->xyz) : std::nullopt;
        if (!error) continue;
        // What is right but for rounding belongs into the first bin, and 90° into the one before it.
        const auto bin = static_cast<std::size_t>(std::max(*error - 1e-9, 0.0) / histogram.bin_degrees);
        bins[std::min(bin, bins.size() - 1)] += areas[i];
        histogram.worst_degrees = std::max(histogram.worst_degrees, *error);
        sum += areas[i] * *error;
        area += areas[i];
    }
    if (!(area > 0.0)) return std::nullopt;
    histogram.mean_degrees = std::min(sum / area, histogram.worst_degrees);
    if (histogram.worst_degrees > 90.0 + 1e-6) histogram.most_degrees = 180.0;
    const auto used = static_cast<std::ptrdiff_t>(histogram.most_degrees / histogram.bin_degrees);
    histogram.shares.assign(bins.begin(), bins.begin() + used);
    for (double& share : histogram.shares) share /= area;
    return histogram;
}

std::vector<MeasuredError> measured_errors(const glm::dmat3& m3, double power) {
    constexpr int kSteps = 12;
    const SingularValues svd = singular_values(m3);
    glm::dvec3 logs(1.0, 0.0, -1.0);
    const double unevenness = svd.sigma.z > 0.0 ? std::log(svd.sigma.x / svd.sigma.z) : 0.0;
    if (unevenness > 1e-6) logs = glm::log(svd.sigma) - (std::log(svd.sigma.x) + std::log(svd.sigma.z)) / 2.0;
    logs /= logs.x - logs.z;  // from here on, k = eᵗ
    std::vector<MeasuredError> result;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = std::log(100.0) * i / kSteps;
        const glm::dvec3 sigma = glm::exp(t * logs);
        const glm::dmat3 stretch(svd.v[0] * sigma.x, svd.v[1] * sigma.y, svd.v[2] * sigma.z);
        const NormalMatrices matrices = normal_matrices(svd.u * glm::transpose(stretch));
        result.push_back({std::exp(t), power, worst_error(matrices, power)});
    }
    return result;
}

std::vector<MeasuredError> measured_between_the_rules(const NormalMatrices& matrices) {
    constexpr int kSteps = 8;
    std::vector<MeasuredError> result;
    const std::optional<double> k = matrices.condition();
    for (int i = 0; k && i <= kSteps; ++i) {
        const double power = 1.0 - 2.0 * i / kSteps;
        result.push_back({*k, power, worst_error(matrices, power)});
    }
    return result;
}

}  // namespace normalscope

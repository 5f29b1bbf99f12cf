#include "core/frame/axis_handles.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr double kBeyond = 1.15;  // of the extent: outside the object, yet within the picture
constexpr double kLeast = 0.4;    // of the largest extent, for a flat object: lest the knobs crowd together

auto first_scale(const std::vector<StackEntry>& stack) {
    return std::ranges::find_if(stack, [](const StackEntry& e) { return std::holds_alternative<Scale>(e); });
}

}  // namespace

std::vector<AxisHandle> axis_handles(const Scene& scene, const glm::dvec3& extent) {
    if (scene.stack_position) return {};  // half a scale has no knob to drag
    const auto scale = first_scale(scene.stack);
    const bool any = scale != scene.stack.end();
    const glm::dvec3 factors = any ? std::get<Scale>(*scale).factors : glm::dvec3(1.0);
    const Transform<World, Object> after(product({any ? scale + 1 : scene.stack.begin(), scene.stack.end()}));
    const double largest = std::max({extent.x, extent.y, extent.z}), least = kLeast * (largest > 0.0 ? largest : 1.0);
    std::vector<AxisHandle> handles;
    for (int axis = 0; axis < 3; ++axis) {
        Vector<Object> direction;
        direction.xyz[axis] = std::max(kBeyond * extent[axis], least);
        AxisHandle handle{axis, after(Point<Object>{}), after(Point<Object>{}, direction), factors[axis]};
        // An M that is not affine takes the knob elsewhere along the axis.
        if (const Point<Object> knob{factors[axis] * direction.xyz};
            !after.affine() && factors[axis] != 0.0 && after.reaches(knob))
            handle.unit = (1.0 / factors[axis]) * (after(knob) - handle.origin);
        if (glm::length(handle.unit.xyz) > 1e-12) handles.push_back(handle);
    }
    return handles;
}

std::vector<AxisHandle> handles_in_view(const Scene& scene, const glm::dvec3& extent, const CameraView& view) {
    std::vector<AxisHandle> handles = axis_handles(scene, extent);
    if (scene.view == ViewMode::Flat)
        std::erase_if(handles, [&](const AxisHandle& handle) {
            const glm::dvec3 along = glm::normalize(handle.unit.xyz);
            return std::hypot(glm::dot(along, view.right().xyz), glm::dot(along, view.up().xyz)) < 0.98;
        });
    return handles;
}

std::optional<AxisHandle> handle_at(const std::vector<AxisHandle>& handles, const CameraView& view, glm::dvec2 pixel,
                                    double reach) {
    std::optional<AxisHandle> found;
    double nearest_depth = 0.0;
    for (const AxisHandle& handle : handles) {
        const glm::dvec3 knob = view.pixel(handle.knob());
        if (knob.z <= 0.0 || glm::length(glm::dvec2(knob) - pixel) > reach) continue;
        if (found && knob.z >= nearest_depth) continue;
        found = handle;
        nearest_depth = knob.z;
    }
    return found;
}

std::optional<double> factor_at(const AxisHandle& handle, const CameraView& view, glm::dvec2 pixel) {
    // The point of one line nearest to another: minimise |origin + s unit − (eye + t direction)|.
    const Ray<World> ray = view.ray(pixel);
    const glm::dvec3 u = handle.unit.xyz, d = glm::normalize(ray.direction.xyz), w = handle.origin.xyz - ray.origin.xyz;
    const double uu = glm::dot(u, u), ud = glm::dot(u, d);
    const double determinant = uu - ud * ud;
    if (determinant < 1e-3 * uu) return std::nullopt;
    return (ud * glm::dot(d, w) - glm::dot(u, w)) / determinant;
}

double factor_per_pixel(const AxisHandle& handle, const CameraView& view) {
    const glm::dvec3 from = view.pixel(handle.origin), to = view.pixel(handle.origin + handle.unit);
    return 1.0 / std::max(glm::distance(glm::dvec2(from), glm::dvec2(to)), 1.0);
}

Scene stretched(const Scene& scene, const AxisHandle& handle, double factor, bool uniform) {
    Scene result = scene;
    if (first_scale(result.stack) == result.stack.end()) result.stack.insert(result.stack.begin(), Scale{});
    glm::dvec3& factors = std::get<Scale>(*std::ranges::find_if(result.stack, [](const StackEntry& e) {
                              return std::holds_alternative<Scale>(e);
                          })).factors;
    // Hundredths, of whatever size it is: what one drags to should be a number one can say.
    const double before = factors[handle.axis], size = std::abs(before);
    const bool ordinary = size == 0.0 || (size >= 0.01 && size <= 100.0);
    const double per = ordinary ? 100.0 : std::pow(10.0, 2.0 - std::floor(std::log10(size))),
                 most = ordinary ? 100.0 : std::max(100.0, 100.0 * size);
    const double rounded = std::clamp(std::round(per * factor) / per, -most, most) + 0.0;
    if (uniform && before != 0.0)
        factors *= rounded / before;
    else if (uniform)
        factors = glm::dvec3(rounded);
    else
        factors[handle.axis] = rounded;
    return result;
}

}  // namespace normalscope

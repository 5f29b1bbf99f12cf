#include "core/picture/preview.h"

#include "core/scene/palette.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace normalscope {

namespace {

constexpr int kSamples = 2;  // a side, of each pixel

const glm::dvec3 kLight = glm::normalize(glm::dvec3(-0.5, 0.8, 0.6));  // as seen by the camera: right, up, backward

// Its colour, and 1 where the ray meets the surface; all 0 where it does not.
glm::dvec4 seen(const ImplicitSurface& surface, const CameraView& view, const Ray<World>& ray) {
    const Ray<Object> object_ray{{ray.origin.xyz}, {ray.direction.xyz}};
    const auto t = surface.first_hit(object_ray);
    if (!t) return glm::dvec4(0.0);
    const glm::dvec3 gradient = surface.at(object_ray.origin + *t * object_ray.direction).gradient;
    const double slope = glm::length(gradient);
    const glm::dvec3 backward = -glm::normalize(ray.direction.xyz);
    glm::dvec3 n = slope > 0.0 && std::isfinite(slope) ? gradient / slope : backward;
    const ThemeColors colors = theme_colors(Theme::Light);
    const bool outside = glm::dot(n, backward) >= 0.0;
    if (!outside) n = -n;
    const glm::dvec3 right = view.right().xyz, up = view.up().xyz;
    const glm::dvec3 light = kLight.x * right + kLight.y * up + kLight.z * glm::cross(right, up);
    const double lit = 0.42 + 0.58 * glm::max(glm::dot(n, light), 0.0);
    return {lit * glm::dvec3(outside ? colors.surface : colors.inside), 1.0};
}

}  // namespace

Image preview(const ImplicitSurface& surface, const Camera& camera, int side, const Stop& stop) {
    Image image = make_image({side, side});
    const double fits = 0.9 * surface.source().bound * (surface.source().clip == Clip::Box ? 1.4 : 1.0);
    const CameraView view(framed(camera, {}, fits), glm::dvec2(side));
    for (int y = 0; y < side && !stop.asked(); ++y)
        for (int x = 0; x < side; ++x) {
            glm::dvec4 sum(0.0);
            for (int k = 0; k < kSamples * kSamples; ++k)
                sum += seen(
                    surface, view,
                    view.ray(glm::dvec2(x, y) + (glm::dvec2(k % kSamples, k / kSamples) + 0.5) / double{kSamples}));
            if (sum.a == 0.0) continue;
            const glm::dvec3 color = 255.0 * glm::clamp(glm::dvec3(sum) / sum.a, 0.0, 1.0);
            for (int i = 0; i < 3; ++i) image.pixel(x, y)[i] = static_cast<std::uint8_t>(std::lround(color[i]));
            image.pixel(x, y)[3] = static_cast<std::uint8_t>(std::lround(255.0 * sum.a / (kSamples * kSamples)));
        }
    return image;
}

}  // namespace normalscope

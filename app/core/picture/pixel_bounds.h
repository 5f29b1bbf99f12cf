#pragma once

#include "core/frame/frame.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <limits>

namespace normalscope {

/// Grows over the places in a pane's picture of the points that are added.
class PixelBounds {
public:
    explicit PixelBounds(const CameraView& view) : view_(view) {}

    void add(const glm::dvec3& world) {
        const glm::dvec3 pixel = view_.pixel({world});
        in_front_ = in_front_ && pixel.z > 0.0;  // not where it is NaN
        low_ = glm::min(low_, glm::dvec2(pixel));
        high_ = glm::max(high_, glm::dvec2(pixel));
    }
    void add_cube(const glm::dvec3& centre, double half) {
        for (int corner = 0; corner < 8; ++corner)
            add(centre + half * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    }
    /// Everything within `reach` of an object that lies in the box from −extent to extent.
    void add_object(const glm::dmat4& world_from_object, const glm::dvec3& extent, double reach) {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            add_cube(in_world(world_from_object, signs * extent), reach);
        }
    }
    /// Where a point goes; what a projective matrix sends beyond infinity counts as behind the eye.
    glm::dvec3 in_world(const glm::dmat4& world_from_object, const glm::dvec3& p) {
        const glm::dvec4 world = world_from_object * glm::dvec4(p, 1.0);
        in_front_ = in_front_ && world.w > 0.0;
        return glm::dvec3(world) / world.w;
    }
    /// In the pane's pixels, cut to the pane.
    PixelRect box(glm::ivec2 size) const {
        constexpr double kMargin = 2.0;  // samples lie beside a pixel's centre, and the driver snaps vertices
        if (!in_front_) return {{0, 0}, size};
        if (!(low_.x <= high_.x)) return {};
        const glm::dvec2 limit(size);
        const glm::ivec2 from(glm::clamp(glm::floor(low_ - kMargin), glm::dvec2(0.0), limit));
        const glm::ivec2 to(glm::clamp(glm::ceil(high_ + kMargin), glm::dvec2(0.0), limit));
        return {from, to - from};
    }

private:
    const CameraView& view_;
    glm::dvec2 low_{std::numeric_limits<double>::infinity()}, high_{-std::numeric_limits<double>::infinity()};
    bool in_front_ = true;
};

}  // namespace normalscope

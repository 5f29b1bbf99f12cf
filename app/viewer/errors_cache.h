#pragma once

#include "core/surface/surface.h"

#include <memory>
#include <optional>

namespace normalscope {

/// The error statistics go over every normal: they are made anew only when the matrix or the surface has changed.
class ErrorsCache {
public:
    const std::optional<ErrorStatistics>& get(const Scene& scene, const std::shared_ptr<const Surface>& surface) {
        const Transform<World, Object> m = world_from_object(scene);
        const std::optional<NormalMap> naive = normal_map(scene, m, Rule::Naive);
        if (surface_ == surface && matrix_ == m.matrix() && naive_ == naive) return errors_;
        surface_ = surface;
        matrix_ = m.matrix();
        naive_ = naive;
        errors_ = naive ? error_statistics(surface->mesh, *naive, m) : std::nullopt;
        return errors_;
    }

private:
    std::shared_ptr<const Surface> surface_;
    glm::dmat4 matrix_{0.0};
    std::optional<NormalMap> naive_;
    std::optional<ErrorStatistics> errors_;
};

}  // namespace normalscope

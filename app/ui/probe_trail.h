#pragma once

#include "core/frame/frame.h"
#include "core/scene/scene.h"
#include "ui/kit/style.h"

#include <optional>
#include <vector>

namespace normalscope {

/// The angle along the way that the probe has gone, as a small plot in the picture's upper right corner. It begins anew where
/// the probe leaps, and goes where anything else changes.
class ProbeTrail {
public:
    /// To be told of every frame.
    void follow(const Scene& scene, const Frame& frame);
    void draw(const Look& look, const Frame& frame) const;
    std::size_t size() const { return steps_.size(); }

private:
    struct Step {
        double way;      ///< so far, in object space
        double degrees;  ///< between the naive and the right normal
    };
    std::vector<Step> steps_;
    std::optional<Scene> scene_;  ///< of the last frame
    std::optional<Point<Object>> at_;
};

}  // namespace normalscope

#pragma once

#include "core/base/beside.h"
#include "core/surface/surface.h"

#include <memory>
#include <optional>

namespace normalscope {

/// The scene's surface without waiting for it: some formulas take seconds. While theirs is made in the background, the one before
/// is shown.
class SurfaceInTime {
public:
    struct Shown {
        Scene scene;  ///< with the surface that is shown
        std::shared_ptr<const Surface> surface;
    };
    /// Waits a tenth of a second at most, if there is a surface to be shown instead. Throws InputError.
    Shown get(const Scene& scene);
    /// However long it takes. Throws InputError.
    std::shared_ptr<const Surface> get_now(const Scene& scene);
    /// What has been made elsewhere.
    void take(std::unique_ptr<SurfaceCache> surfaces);

    bool making() const { return static_cast<bool>(making_); }
    void stop_making() { making_ = {}; }

private:
    void begin(const Scene& scene);

    std::unique_ptr<SurfaceCache> surfaces_ = std::make_unique<SurfaceCache>();
    Beside<std::unique_ptr<SurfaceCache>> making_;
    SurfaceSource made_from_;  ///< what is being made
};

}  // namespace normalscope

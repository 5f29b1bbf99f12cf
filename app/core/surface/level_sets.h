#pragma once

#include "core/scene/scene.h"
#include "core/surface/implicit_surface.h"

#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace normalscope {

/// A formula's level sets f = c on a plane, as far as the formula's ball or cube reaches, and ∇f there. Object space,
/// immutable. Where f has no finite value there is nothing.
struct LevelSets {
    static constexpr int kMostBands = 12;  ///< on either side of zero; the outermost have no end

    std::array<glm::dvec3, 2> across{glm::dvec3(0.0), glm::dvec3(0.0)};  ///< unit vectors in the plane
    glm::dvec3 middle{0.0};                                              ///< of what is shown of the plane
    double reach = 0.0;                                                  ///< from the middle to the edge
    /// Between neighbouring levels: 1, 2 or 5 times a power of ten. 0: f has no value here but perhaps 0.
    double step = 0.0;

    /// c from band · step to (band + 1) · step: inside below 0, outside from 0 on.
    struct Patch {
        std::array<glm::dvec3, 3> corners;
        int band;
    };
    struct Line {
        std::array<glm::dvec3, 2> ends;
        int level;  ///< c = level · step
    };
    struct Arrow {
        Point<Object> base;
        Normal<Object> gradient;  ///< finite, and not 0
    };
    std::vector<Patch> patches;
    std::vector<Line> lines;
    std::vector<Arrow> gradients;  ///< on a regular grid
    /// The places farthest from any edge in f < 0 and in f > 0.
    std::optional<glm::dvec3> inside, outside;
};

/// The scene's level sets; null where it has no slice or its surface no formula.
std::shared_ptr<const LevelSets> level_sets(const Scene& scene, const ImplicitSurface* surface);
/// Bands are made of squares as large as f allows, for a picture; or lines are as fine as can be.
enum class Detail { Bands, Lines };
LevelSets level_sets(const ImplicitSurface& surface, const Slice& slice, Detail detail = Detail::Bands);

/// Keeps the last ones while neither the formula nor the plane changes.
class LevelSetsCache {
public:
    std::shared_ptr<const LevelSets> get(const Scene& scene, const std::shared_ptr<const ImplicitSurface>& surface);

private:
    std::shared_ptr<const ImplicitSurface> surface_;
    std::optional<Slice> slice_;
    std::shared_ptr<const LevelSets> sets_;
};

}  // namespace normalscope

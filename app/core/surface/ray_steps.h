#pragma once

#include "core/math/camera.h"
#include "core/math/transform.h"
#include "core/scene/scene.h"
#include "core/surface/surface.h"

#include <array>
#include <optional>
#include <string_view>

namespace normalscope {

/// What a ray tracer does with one ray, step by step, with the numbers of each. Steps 0 to 7 as `name` has them; what a
/// step has come to nothing for is empty, and so is all that follows from it.
struct RaySteps {
    enum class End {
        Whole,      ///< light falls on a point
        NoInverse,  ///< M has no inverse: the ray has no image in object space
        NotAffine,  ///< M bends straight lines' t: only an affine M keeps it
        Misses,     ///< nothing is hit
        NoNormal,   ///< ∇f is zero or does not exist where the ray hits
    };
    static constexpr std::array<std::string_view, 8> kNames{
        "world ray", "object ray", "hit", "object point", "gradient", "inverse transpose", "normalise", "light"};

    Ray<World> world;                        ///< 0: the direction has unit length
    std::optional<Ray<Object>> object;       ///< 1: M⁻¹ on both; the direction is left as long as it comes
    std::optional<double> t;                 ///< 2: in lengths of the direction, the same in both spaces
    std::optional<Point<Object>> point;      ///< 3
    std::optional<Normal<Object>> gradient;  ///< 4: ∇f; of shapes and meshes, which have no f, their unit normal
    std::optional<Normal<World>> normal;     ///< 5: as long as it comes
    std::optional<Normal<World>> unit;       ///< 6
    Vector<World> toward_light;              ///< of unit length
    std::optional<double> brightness;        ///< 7: n·l

    std::optional<Point<World>> point_world;  ///< o + t d
    std::optional<double> f;                  ///< at the object point; formulas only
    /// What goes wrong where the object ray's direction is made of unit length first: the other t, and where the world
    /// ray is then.
    std::optional<double> t_if_normalised;
    std::optional<Point<World>> point_if_normalised;
    std::optional<double> naive_brightness;  ///< n·l with M n for the normal

    End end = End::Whole;
    int last_step = AimedRay::kLastStep;  ///< as far as it goes
};

RaySteps ray_steps(const Scene& scene, const Surface& surface, const Transform<World, Object>& world_from_object,
                   const CameraView& view);

/// Where the scene's ray starts and what it is aimed at, with what it leaves to the view.
std::array<Point<World>, 2> aim(const AimedRay& ray, const Camera& camera, const CameraView& view);

}  // namespace normalscope

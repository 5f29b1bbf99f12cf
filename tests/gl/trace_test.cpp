// What the fragment shader finds, against the exact ray tracer on the processor: pixel by pixel.

#include "support.h"

#include "core/math/stack.h"
#include "core/surface/implicit_surface.h"
#include "gl/tracer.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <string>

namespace normalscope {
namespace {

struct Case {
    const char* name;
    const char* formula;
    double bound = 2.0;
    /// Pixels that may disagree, of those that show the surface or should: where two sheets are nearer than floats tell.
    double share = 0.001;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

constexpr glm::ivec2 kSize(160, 120);

class Trace : public ::testing::TestWithParam<Case> {
protected:
    void SetUp() override { need_context(); }
};

// So near to a miss or to another sheet that rounding decides.
bool is_grazing(const ImplicitSurface& surface, const Ray<Object>& ray, const std::vector<formulas::Root>& roots) {
    if (!roots.empty()) {
        const glm::dvec3 d = ray.direction.xyz;
        const glm::dvec3 n = surface.at(ray.origin + roots[0].t * ray.direction).gradient;
        if (std::abs(glm::dot(n, d)) < 0.03 * glm::length(n) * glm::length(d)) return true;
    }
    return false;
}

TEST_P(Trace, MeetsWhatTheProcessorMeets) {
    const Case& c = GetParam();
    ImplicitSurface surface({.formula = c.formula, .bound = c.bound});
    surface.check_floats(polygonised(surface, 40));
    const CameraView view({.azimuth = 33.0, .elevation = 21.0, .zoom = 2.4 / c.bound}, kSize);
    const glm::dmat4 object_from_world = glm::inverse(matrix(Scale{{0.5, 1.4, 1.0}}));
    Tracer tracer;
    tracer.trace(surface, view, kSize, object_from_world, {});
    const std::vector<glm::vec4> hits = texels(tracer.centres().id(), kSize);

    int shown = 0, wrong = 0;
    std::string first_wrong;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const Ray<World> world = view.ray({x + 0.5, kSize.y - y - 0.5});
            const Ray<Object> ray{{glm::dvec3(object_from_world * glm::dvec4(world.origin.xyz, 1.0))},
                                  {glm::dvec3(object_from_world * glm::dvec4(world.direction.xyz, 0.0))}};
            const std::vector<formulas::Root> roots = surface.hits(ray, formulas::Wanted::All);
            const glm::vec4 hit =
                hits[static_cast<std::size_t>(y) * static_cast<std::size_t>(kSize.x) + static_cast<std::size_t>(x)];
            for (int k = 0; k < 4; ++k) ASSERT_FALSE(std::isnan(hit[k])) << c.formula;
            if (roots.empty() && hit.w == 0.0f) continue;
            ++shown;
            // The shader's rays end on the far plane: t is in other lengths.
            const glm::dvec4 far = glm::inverse(view.clip_from_world()) *
                                   glm::dvec4(2.0 * (x + 0.5) / kSize.x - 1.0, 2.0 * (y + 0.5) / kSize.y - 1.0, 1, 1);
            const double unit =
                glm::length(glm::dvec3(far) / far.w - world.origin.xyz) / glm::length(world.direction.xyz);
            const double t = roots.empty() ? 0.0 : roots[0].t;
            const bool agrees = !roots.empty() && hit.w > 0.0f && std::abs(hit.w * unit - t) < 2e-3 * c.bound;
            if (agrees || is_grazing(surface, ray, roots)) continue;
            ++wrong;
            if (first_wrong.empty())
                first_wrong = std::to_string(x) + ", " + std::to_string(y) + ": t = " + std::to_string(hit.w * unit) +
                              ", not " + std::to_string(t) + " of " + std::to_string(roots.size());
        }
    EXPECT_GT(shown, 300);
    EXPECT_LE(wrong, c.share * shown) << wrong << " of " << shown << ", such as " << first_wrong;
}

constexpr std::array kCases{
    Case{"Plane", "x+2y-z"},
    Case{"Sphere", "x^2+y^2+z^2-1"},
    Case{"Torus", "(x^2+y^2+z^2+0.75)^2-4(x^2+y^2)"},
    Case{"Cone", "x^2+y^2-z^2"},
    Case{"DoubleSphere", "(x^2+y^2+z^2-1)^2"},
    Case{"ThinShell", "(x^2+y^2+z^2-1)^2-0.0001"},
    Case{"WhitneyUmbrella", "x^2-y^2 z"},
    Case{"DingDong", "x^2+y^2-(1-z)z^2"},
    Case{"Cayley", "4(x^2+y^2+z^2)+16x y z-1"},
    Case{"BarthSextic", "4(2.618034x^2-y^2)(2.618034y^2-z^2)(2.618034z^2-x^2)-4.236068(x^2+y^2+z^2-1)^2"},
    Case{"Heart", "(x^2+9/4y^2+z^2-1)^3-x^2z^3-9/80y^2z^3"},
    Case{"Steiner", "x^2y^2+y^2z^2+z^2x^2+x y z", 2.0, 0.005},  // its double lines go on beyond it, as lines only
    Case{"Degree9", "x^9+y^9+z^9-1"},
    Case{"Degree20", "x^20+y^20+z^20-1"},
    Case{"Gyroid", "sin(3x)cos(3y)+sin(3y)cos(3z)+sin(3z)cos(3x)"},
    Case{"Octahedron", "|x|+|y|+|z|-1"},
    Case{"Cube", "max(|x|,max(|y|,|z|))-1"},
    Case{"RootOfSquares", "sqrt(x^2+y^2)-z"},
    Case{"Logarithm", "log(x)+y^2+z^2"},
    Case{"Poles", "1/x+1/y+z"},
    Case{"Tangent", "tan(2x)+y+z"},
    Case{"PolePlane", "x/(x^2+y^2+z^2-1)", 2.0, 0.003},  // zero and pole beside each other
    Case{"PoleOfTangents", "tan(x^2+y^2+z^2)", 2.0, 0.005},
    Case{"PoleBesideACylinder", "(x^2+y^2-1)/(x-0.3)", 2.0, 0.004},
    Case{"Sawtooth", "mod(x,1)-0.5"},
    Case{"Steps", "z-floor(2x)/4"},
    Case{"BranchWithoutAValue", "where(sqrt(-x)+1, x, (x-1)^2+y^2+z^2-0.25)"},
    Case{"EndsWhereItIsCutOff", "x^2+y^2+z^2=4"},
    Case{"CubicPole", "(x/z+z+1)^3-6"},
    Case{"Jump", "z-atan(y/x)", 2.0, 0.005},  // beside which the surface lies as near as one likes
    Case{"Cusps", "|x|^(2/3)+|y|^(2/3)+|z|^(2/3)-1", 2.0, 0.003},
    Case{"BelowWhatFloatsHold", "exp(-100(x^2+y^2+z^2))-exp(-100)", 1.5},
    Case{"Cancelling", "(x+1000)^2-1000^2+(y+1000)^2-1000^2+(z+1000)^2-1000^2-2000(x+y+z)-1", 1.5},
    Case{"TouchesSmoothly", "sin(x+y/2)^2"},
    Case{"CloseSheetsBesideAKink", "|x^2+y^2+z^2-1|-0.0001"},
    Case{"TouchesInAKink", "|x^2+y^2+z^2-1|"},
};
INSTANTIATE_TEST_SUITE_P(Surfaces, Trace, ::testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace normalscope

#include "core/lessons/scene_caption.h"

#include "core/scene/mistakes.h"

#include <cmath>
#include <cstdio>

namespace normalscope {

namespace {

std::string degrees(double angle) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f°", angle);
    return text;
}

std::string about(const NormalMatrices& m) {
    if (m.rank == 2)
        return "The object is flattened: M has no inverse, and the cofactor matrix still gives its normal.";
    if (m.rank < 2) return "M leaves no surface: there is no normal.";
    const double bound = m.error_bound_degrees().value_or(0.0);
    if (bound < 1e-6) return "M stretches alike in every direction: M n has the right direction.";
    return "M stretches unevenly: M n is off by up to " + degrees(bound) + ".";
}

}  // namespace

SceneSaid said_of(const Scene& scene) {
    const Transform<World, Object> transform = world_from_object(scene);
    const NormalMatrices& m = transform.normal_matrices_by_rule();
    SceneSaid said{scene.about.empty() ? about(m) : scene.about, {}};
    switch (scene.rule) {
        case Rule::Naive:
            said.equations.push_back("n_naive = " + std::string(normal_formula(Rule::Naive, scene.mistake)));
            break;
        case Rule::InverseTranspose: said.equations.emplace_back("n_world = (M₃⁻¹)ᵀ n_obj"); break;
        case Rule::Cofactor: said.equations.emplace_back("n_world = cof(M₃) n_obj"); break;
    }
    return said;
}

}  // namespace normalscope

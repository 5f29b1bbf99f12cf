#include "core/lessons/scene_caption.h"

#include "core/base/decimal.h"
#include "core/scene/mistakes.h"

#include <cmath>

namespace normalscope {

namespace {

std::string degrees(double angle) { return with_decimals(angle, 1) + "°"; }

std::string about(const NormalMatrices& m, const Scene& scene) {
    if (m.rank == 2)
        return "The object is flattened: M has no inverse, and the cofactor matrix still gives its normal.";
    if (m.rank < 2) return "M leaves no surface: there is no normal.";
    const double p = shown_power(scene), bound = m.error_bound_degrees(p).value_or(0.0);
    if (p != 1.0) {
        const InNaivePlace shown = in_naive_place(scene);
        if (bound < 1e-6) return shown.formula + ", " + shown.title + ", has the right direction.";
        return shown.formula + ", " + shown.title + ", is off by up to " + degrees(bound) + ".";
    }
    if (bound < 1e-6) return "M stretches equally in every direction: M n has the right direction.";
    return "M stretches unevenly: M n is off by up to " + degrees(bound) + ".";
}

// Lists have no full stops; what is said has one.
std::string as_sentence(std::string about) {
    const char last = about.back();
    const bool word = (last >= 'a' && last <= 'z') || (last >= 'A' && last <= 'Z') || (last >= '0' && last <= '9');
    if (word || last == ')') about += '.';
    return about;
}

}  // namespace

std::string said_of_m(const Scene& scene) {
    const Transform<World, Object> m = world_from_object(scene);
    return m.affine() ? about(m.normal_matrices_by_rule(), scene)
                      : "M is not affine: normals follow their tangent planes, and no 3×3 rule is right.";
}

SceneSaid said_of(const Scene& scene) {
    SceneSaid said{scene.about.empty() ? said_of_m(scene) : as_sentence(scene.about), {}};
    switch (scene.rule) {
        case Rule::Naive: said.equations.push_back("n_naive = " + normal_formula(Rule::Naive, scene)); break;
        case Rule::InverseTranspose: said.equations.emplace_back("n_world = (M₃⁻¹)ᵀ n_obj"); break;
        case Rule::Cofactor: said.equations.emplace_back("n_world = cof(M₃) n_obj"); break;
    }
    return said;
}

}  // namespace normalscope

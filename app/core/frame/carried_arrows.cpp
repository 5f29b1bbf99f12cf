#include "core/frame/carried_arrows.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace normalscope {

namespace {

// On the way from one vector to another it turns, and does not shrink in between as it would by the straight way.
glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double t) {
    const double la = glm::length(a), lb = glm::length(b);
    const double angle = glm::radians(angle_degrees(a, b).value_or(0.0)), sine = std::sin(angle);
    if (sine < 1e-6) return glm::mix(a, b, t);
    const glm::dvec3 direction = (std::sin((1.0 - t) * angle) / sine) / la * a + (std::sin(t * angle) / sine) / lb * b;
    return glm::mix(la, lb, t) * direction;
}

class Lines {
public:
    Lines(const DerivationAt& at, const ProbeInWorld& probe, const glm::dmat3& m3, const glm::dvec3& n_world)
        : at_(at),
          object_(probe.object.point.xyz),
          world_(probe.point.xyz),
          turned_(m3 * object_),
          n_obj_(probe.object.normal.xyz),
          v_obj_(probe.object.tangents.at(at.tangent).xyz),
          n_world_(n_world),
          v_world_(m3 * v_obj_),
          back_(glm::transpose(m3) * n_world) {}

    CarriedArrows shown() {
        using enum DerivationLine;
        switch (at_.line) {
            case Given:
                add(object_, n_obj_, "n object", Meaning::Object);
                add(object_, v_obj_, "v object", Meaning::Tangent);
                result_.right_angle = {0, 1};
                break;
            case Wanted:
                add(world_, n_world_, "n world", Meaning::InverseTranspose);
                add(world_, v_world_, "v world", Meaning::Tangent);
                result_.right_angle = {0, 1};
                break;
            case Tangent:
            case AsMatrices:
            case TransposedTwice: {
                const double t = at_.line == Tangent ? at_.carried : 1.0;
                add(world_, n_world_, "n world", Meaning::InverseTranspose);
                carry(v_obj_, v_world_, t, "M₃ v object", Meaning::Tangent);
                add(object_, v_obj_, "v object", Meaning::Tangent, true);
                if (t >= 1.0) result_.right_angle = {0, 1};
                break;
            }
            case ProductOfTransposes:
            case AsDotProduct: {
                const double t = at_.line == ProductOfTransposes ? at_.carried : 1.0;
                add(object_, v_obj_, "v object", Meaning::Tangent);
                carry(back_, n_world_, 1.0 - t, "M₃ᵀ n world", Meaning::InverseTranspose);
                add(world_, n_world_, "n world", Meaning::InverseTranspose, true);
                if (t >= 1.0) result_.right_angle = {0, 1};
                break;
            }
            case SameDirection:
                add(object_, n_obj_, "n object", Meaning::Object);
                add(object_, back_, "M₃ᵀ n world", Meaning::InverseTranspose);
                break;
            case Solved:
            case Rule:
                carry(n_obj_, n_world_, at_.line == Solved ? at_.carried : 1.0, "(M₃⁻¹)ᵀ n object",
                      Meaning::InverseTranspose);
                add(world_, v_world_, "v world", Meaning::Tangent);
                add(object_, n_obj_, "n object", Meaning::Object, true);
                if (at_.line == Rule || at_.carried >= 1.0) result_.right_angle = {0, 1};
                break;
        }
        return std::move(result_);
    }

private:
    void add(const glm::dvec3& base, const glm::dvec3& vector, std::string name, Meaning meaning, bool quiet = false) {
        result_.arrows.push_back({base, vector, std::move(name), meaning, quiet});
    }
    // From the object, at 0, to the world, at 1: M3 first, and then the translation, which moves the place and leaves the
    // vector as it is.
    void carry(const glm::dvec3& in_object, const glm::dvec3& in_world, double t, std::string name, Meaning meaning) {
        const bool translates = glm::length(world_ - turned_) > 1e-9 * (1.0 + glm::length(world_));
        const double by_m3 = translates ? 0.6 : 1.0;  // of the time
        const double share = std::min(t / by_m3, 1.0);
        const glm::dvec3 base = t < by_m3 || !translates ? glm::mix(object_, translates ? turned_ : world_, share)
                                                         : glm::mix(turned_, world_, (t - by_m3) / (1.0 - by_m3));
        add(base, between(in_object, in_world, share), std::move(name), meaning);
    }

    const DerivationAt& at_;
    glm::dvec3 object_, world_;
    glm::dvec3 turned_;  ///< M3 p, before the translation
    glm::dvec3 n_obj_, v_obj_, n_world_, v_world_;
    glm::dvec3 back_;  ///< M3ᵀ n_world
    CarriedArrows result_;
};

}  // namespace

CarriedArrows carried_arrows(const DerivationAt& at, const ProbeInWorld& probe,
                             const Transform<World, Object>& world_from_object) {
    if (!probe.object.has_normal() || !world_from_object.affine()) return {};
    const auto n_world = world_from_object(probe.object.normal);
    if (!n_world) return {};
    return Lines(at, probe, world_from_object.normal_matrices_by_rule().naive, n_world->xyz).shown();
}

}  // namespace normalscope

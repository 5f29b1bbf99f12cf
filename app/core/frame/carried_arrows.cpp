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

// Where an arrow stands in each space, and on its way: M3 takes it to `turned`, and the translation to the world.
struct Stand {
    glm::dvec3 object, turned, world;
};

class Lines {
public:
    Lines(const DerivationAt& at, const ProbeInWorld& probe, const glm::dmat3& m3, const glm::dvec3& n_world)
        : at_(at),
          point_(stand(m3, probe.object.point, probe.point)),
          edge_(!probe.polygon.empty()),
          edge_from_(edge_ ? stand(m3, probe.object.polygon[at.tangent], probe.polygon[at.tangent]) : point_),
          n_obj_(probe.object.normal.xyz),
          v_obj_(probe.object.tangents.at(at.tangent).xyz),
          n_world_(n_world),
          v_world_(m3 * v_obj_),
          back_(glm::transpose(m3) * n_world) {}

    CarriedArrows shown() {
        using enum DerivationLine;
        switch (at_.line) {
            case Given:
                n(point_.object, n_obj_, "n object", Meaning::Object);
                v(edge_from_.object, v_obj_, "v object");
                result_.right_angle = {0, 1};
                break;
            case Wanted:
                n(point_.world, n_world_, "n world");
                v(edge_from_.world, v_world_, "v world");
                result_.right_angle = {0, 1};
                break;
            case Tangent:
            case AsMatrices:
            case TransposedTwice: {
                const double t = at_.line == Tangent ? at_.carried : 1.0;
                n(point_.world, n_world_, "n world");
                const auto [base, vector] = on_the_way(edge_from_, v_obj_, v_world_, t);
                v(base, vector, "M₃ v object");
                v(edge_from_.object, v_obj_, "v object", true);
                if (t >= 1.0) result_.right_angle = {0, 1};
                break;
            }
            case ProductOfTransposes:
            case AsDotProduct: {
                const double t = at_.line == ProductOfTransposes ? at_.carried : 1.0;
                const auto [base, vector] = on_the_way(point_, back_, n_world_, 1.0 - t);
                v(edge_from_.object, v_obj_, "v object");
                n(base, vector, "M₃ᵀ n world");
                n(point_.world, n_world_, "n world", Meaning::InverseTranspose, true);
                if (t >= 1.0) result_.right_angle = {1, 0};
                break;
            }
            case SameDirection:
                n(point_.object, n_obj_, "n object", Meaning::Object);
                n(point_.object, back_, "M₃ᵀ n world");
                break;
            case Solved:
            case Rule: {
                const auto [base, vector] =
                    on_the_way(point_, n_obj_, n_world_, at_.line == Solved ? at_.carried : 1.0);
                n(base, vector, "(M₃⁻¹)ᵀ n object");
                v(edge_from_.world, v_world_, "v world");
                n(point_.object, n_obj_, "n object", Meaning::Object, true);
                if (at_.line == Rule || at_.carried >= 1.0) result_.right_angle = {0, 1};
                break;
            }
        }
        return std::move(result_);
    }

private:
    static Stand stand(const glm::dmat3& m3, const Point<Object>& object, const Point<World>& world) {
        return {object.xyz, m3 * object.xyz, world.xyz};
    }
    void n(const glm::dvec3& base, const glm::dvec3& vector, std::string name,
           Meaning meaning = Meaning::InverseTranspose, bool quiet = false) {
        result_.arrows.push_back({base, vector, std::move(name), meaning, quiet});
    }
    void v(const glm::dvec3& base, const glm::dvec3& vector, std::string name, bool quiet = false) {
        result_.arrows.push_back({base, vector, std::move(name), Meaning::Tangent, quiet, edge_});
    }
    // Base and vector from the object, at 0, to the world, at 1: M3 first, and then the translation, which moves the place
    // and leaves the vector as it is.
    static std::pair<glm::dvec3, glm::dvec3> on_the_way(const Stand& stand, const glm::dvec3& in_object,
                                                        const glm::dvec3& in_world, double t) {
        const bool translates = glm::length(stand.world - stand.turned) > 1e-9 * (1.0 + glm::length(stand.world));
        const double by_m3 = translates ? 0.6 : 1.0;  // of the time
        const double share = std::min(t / by_m3, 1.0);
        const glm::dvec3 base = t < by_m3 || !translates
                                    ? glm::mix(stand.object, translates ? stand.turned : stand.world, share)
                                    : glm::mix(stand.turned, stand.world, (t - by_m3) / (1.0 - by_m3));
        return {base, between(in_object, in_world, share)};
    }

    const DerivationAt& at_;
    Stand point_;
    bool edge_;        ///< v is one of H's
    Stand edge_from_;  ///< where v begins
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

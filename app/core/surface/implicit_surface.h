#pragma once

#include "core/base/beside.h"
#include "core/formula/formula.h"
#include "core/math/camera.h"
#include "core/mesh/mesh.h"
#include "core/program/evaluate.h"
#include "core/program/glsl.h"
#include "core/program/roots.h"
#include "core/scene/scene.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// f(x, y, z) = 0 within a ball or a cube, ready to be evaluated, met by rays and drawn. Object space, immutable.
class ImplicitSurface {
public:
    /// Throws InputError for a formula that cannot be read, or has no derivatives that fit.
    explicit ImplicitSurface(const FormulaSurface& source);

    const FormulaSurface& source() const { return source_; }
    /// f as it is written.
    const formulas::Formula& formula() const { return *formula_; }
    /// What all else works on: an expression with f's sign everywhere, f itself if not one that underflows less
    /// (core/formula/same_sign.h). Its gradient has the direction of ∇f, where ∇f has one.
    const formulas::Formula& tame_formula() const { return *tame_; }
    /// It, with values for its parameters; and f itself.
    const formulas::Program& program() const { return program_; }
    const formulas::Program& written_program() const { return written_; }
    /// f and ∇f for the graphics processor; the parameters are uniforms. The same for all values of the parameters.
    const formulas::Glsl& glsl(formulas::Precision precision = formulas::Precision::Single) const {
        return precision == formulas::Precision::Double && double_glsl_ ? *double_glsl_ : *glsl_;
    }
    /// Whether floats show f's signs beside these points of the surface as doubles do. If not, there is GLSL in doubles,
    /// too: without them the picture is one of rounding.
    void check_floats(const Mesh& mesh);
    formulas::Precision precision() const {
        return double_glsl_ ? formulas::Precision::Double : formulas::Precision::Single;
    }
    /// The degree in x, y, z whatever the parameters are; empty where f is no polynomial.
    std::optional<int> degree() const { return degree_; }
    /// f is 0 wherever it has a value: not a surface.
    bool zero_everywhere() const { return zero_everywhere_; }
    /// A point around which f is 0 throughout, where it changes its sign nowhere: a solid in place of a surface.
    const std::optional<glm::dvec3>& zero_throughout() const { return zero_throughout_; }

    /// Where in the ball or cube f = 0 may lie, and somewhat more. Empty where f has no zero there at all, or no surface.
    const std::optional<formulas::Box>& region() const { return region_; }
    /// The same, as closely as intervals tell: for what is far smaller, or thinner, than the ball. Empty where that shows
    /// that f has no zero after all.
    std::optional<formulas::Box> close_region() const;
    /// Nothing of it is worth drawing: no ray meets it from now on.
    void hide() { region_.reset(); }

    bool inside_clip(const glm::dvec3& p) const;
    /// The radius of the ball that cuts the surface off: a hair beyond its bound, so that what ends just there, such as
    /// x² + y² + z² = 4 within 2, is whole.
    double ball() const { return (1.0 + 1e-4) * source_.bound; }
    /// f is 0 at p but for rounding, held against f and ∇f around: small alone says nothing, and at a pole f is large.
    bool lies_on(const glm::dvec3& p) const;
    /// Points all over the ball or cube, as of a grid with so many a side, but off the planes of symmetry, on which f may be
    /// 0, or a way down |f| end on a ridge.
    std::vector<glm::dvec3> points_throughout(int a_side) const;

    /// f and ∇f, both divided by the same number where ∇f is so large that its square would overflow.
    formulas::Sample at(Point<Object> p) const;
    /// f and ∇f as they are written, for who reads them: ∇f is NaN where it does not exist.
    formulas::Sample written_at(Point<Object> p) const;
    /// Beside p ∇f has one direction, and across it another: as |x| has at x = 0, where at() calls its slope 0.
    bool is_kink(Point<Object> p) const;

    /// The first point of the surface that the ray meets: t in lengths of its direction.
    std::optional<double> first_hit(const Ray<Object>& ray, formulas::Effort* effort = nullptr) const;
    /// All of them within the clip, in order.
    std::vector<formulas::Root> hits(const Ray<Object>& ray, formulas::Wanted wanted,
                                     formulas::Effort* effort = nullptr) const;
    /// The part of the ray within the clip; empty where it misses.
    std::optional<std::array<double, 2>> clipped(const Ray<Object>& ray) const;

    /// Goes down the gradient from `p` to f = 0: Newton's steps. Empty where they do not come to rest within `reach`, or not
    /// on the surface.
    std::optional<Point<Object>> onto_surface(Point<Object> p, double reach) const;

private:
    FormulaSurface source_;
    std::shared_ptr<const formulas::Formula> formula_, tame_;
    std::shared_ptr<const formulas::Glsl> glsl_, double_glsl_;
    std::optional<int> degree_;
    formulas::Program program_, written_;
    std::optional<formulas::RayTracer> tracer_;
    bool zero_everywhere_ = false;
    std::optional<glm::dvec3> zero_throughout_;
    std::optional<formulas::Box> region_;
};

/// "f(x, y, z)", "∂f/∂x", "∂f/∂y" or "∂f/∂z": what each line of a formula's writing is about.
inline constexpr std::array<std::string_view, 4> kFormulaNames{"f(x, y, z)", "∂f/∂x", "∂f/∂y", "∂f/∂z"};

/// Triangles near the surface with their vertices on it and exact normals there: where its arrows stand, what is drawn
/// where M has no inverse, what errors are measured over. `cells` a side. Throws Stopped (core/surface/stopped.h).
Mesh polygonised(const ImplicitSurface& surface, int cells, const Stop& stop = {});

}  // namespace normalscope

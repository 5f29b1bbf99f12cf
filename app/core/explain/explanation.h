#pragma once

#include "core/explain/derivation.h"
#include "core/explain/explain_format.h"
#include "core/explain/stack_algebra.h"
#include "core/frame/frame.h"
#include "core/math/map_class.h"
#include "core/math/polar_decomposition.h"
#include "core/scene/scene.h"
#include "core/surface/gradient_report.h"

#include <string>
#include <vector>

namespace normalscope {

/// Everything there is to say about a scene's M and its normals, as data: a panel, a terminal and a document show it
/// alike. What does not exist is empty, and what cannot be said is said in the notes.
struct Explanation {
    std::string about;
    Value m;  ///< 4×4
    bool affine = true;
    NormalMatrices matrices;
    std::optional<Probe> probe;
    std::vector<std::string> notes;
    std::shared_ptr<const ImplicitSurface> implicit;  ///< where the surface comes from a formula
    std::optional<GradientReport> gradient;           ///< of that formula, at the probe
    Derivation derivation;
    std::vector<EntryAlgebra> stack;
    std::vector<OrderOfInverses> orders;  ///< empty for an empty stack
    Decomposition decomposition;
    MapClaims claims;
    std::vector<MapClassRow> classes;
};

/// What is special about a scene's M and what cannot be said of it, in sentences; with how sure its inverse is.
std::vector<std::string> notes(const Scene& scene, const Transform<World, Object>& m,
                               const std::optional<Probe>& probe);

/// Throws InputError as world_from_object does. Independent of the surface, but for its probe: about 0.1 ms. What
/// follows from the surface's formula is left to `explain`.
/// `tangent`: which of the probe's two tangents the derivation follows.
Explanation explanation(const Scene& scene, const std::optional<Probe>& probe, std::size_t tangent = 0);

/// At most 100 columns of Unicode.
std::string explanation_text(const Explanation& e);
/// A whole document for pdflatex, in the colours of the palette.
std::string explanation_latex(const Explanation& e);
/// The equations alone, with the scene's numbers, for a document that loads amsmath and color: colours, then an align*.
std::string equations_latex(const Explanation& e);
/// The keys of `--numbers`, and those of the explanation; renderer and context are null.
std::string explanation_json(const Scene& scene, const Frame& frame, const Explanation& e);

/// What `normalscope explain` prints: the probe is that of a picture of 1280×720. Throws InputError.
std::string explain(const Scene& scene, ExplainFormat format);

}  // namespace normalscope

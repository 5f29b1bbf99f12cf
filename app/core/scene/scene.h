#pragma once

#include "core/formula/graph.h"
#include "core/math/camera.h"
#include "core/math/direction.h"
#include "core/math/normal_rules.h"
#include "core/math/stack.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace normalscope {

enum class Shape { Sphere, Cube, Cylinder, Cone, Torus, Plane, Dodecahedron };
/// Flat: the cut z = 0 of object space and its image, each seen straight on.
enum class ViewMode { Single, Split, Overlay, Flat };
enum class ArrowPlacement { Vertices, Faces };
enum class SurfaceColor { Lit, Error, Normals };
/// The contrast themes are for lecture halls and low vision: black on white, or white on black.
enum class Theme { Light, Dark, LightContrast, DarkContrast };
constexpr bool is_dark(Theme theme) { return theme == Theme::Dark || theme == Theme::DarkContrast; }
constexpr bool has_contrast(Theme theme) { return theme == Theme::LightContrast || theme == Theme::DarkContrast; }
constexpr Theme theme_of(bool dark, bool contrast) {
    if (contrast) return dark ? Theme::DarkContrast : Theme::LightContrast;
    return dark ? Theme::Dark : Theme::Light;
}
/// The other one in lightness, of the same contrast.
constexpr Theme toggled(Theme theme) { return theme_of(!is_dark(theme), has_contrast(theme)); }
enum class Axis { X, Y, Z };

/// A built-in shape that touches the unit sphere or fills the cube [−1, 1]³.
struct ShapeSurface {
    Shape shape = Shape::Sphere;
    int resolution = 64;  ///< segments around, 3 to 512
    friend bool operator==(const ShapeSurface&, const ShapeSurface&) = default;
};
/// A mesh file; the path as the program finds it (relative paths in a scene file start at that file's folder).
struct MeshSurface {
    std::string mesh;
    friend bool operator==(const MeshSurface&, const MeshSurface&) = default;
};
/// What a formula's surface is cut off by.
enum class Clip { Ball, Box };
/// f(x, y, z) = 0 within a ball or a cube about the origin.
struct FormulaSurface {
    std::string formula = "x^2+y^2+z^2-1";
    formulas::Parameters parameters = formulas::kAllOne;  ///< of the letters that occur; the others count for nothing
    double bound = 2.0;                                   ///< the ball's radius, or half the cube's side
    Clip clip = Clip::Ball;
    friend bool operator==(const FormulaSurface&, const FormulaSurface&) = default;
};
using SurfaceSource = std::variant<ShapeSurface, MeshSurface, FormulaSurface>;

/// The normals that can be shown as arrows: those of the untransformed object and those of each rule.
enum class ArrowKind { Object, Naive, InverseTranspose, Cofactor };
inline constexpr std::array kArrowKinds{ArrowKind::Object, ArrowKind::Naive, ArrowKind::InverseTranspose,
                                        ArrowKind::Cofactor};
constexpr ArrowKind arrow_kind(Rule rule) { return static_cast<ArrowKind>(static_cast<int>(rule) + 1); }

struct Arrows {
    ArrowPlacement at = ArrowPlacement::Vertices;
    int every = 1;         ///< every n-th vertex or face
    double length = 0.12;  ///< in object diameters
    int limit = 24;        ///< at most so many of a kind, evenly thinned
    /// Which kinds are drawn; empty: those that the view calls for.
    std::optional<std::vector<ArrowKind>> show;
    friend bool operator==(const Arrows&, const Arrows&) = default;
};

/// What stands in the naive rule's place: that rule itself, or another mistake that programs make with normals, to be
/// held against the right rule (core/scene/mistakes.h tells how each comes about).
enum class Mistake {
    Naive,
    InversesNotReversed,
    NotTransposed,
    NotInverted,
    WOne,
    LeakingTranslation,
    ModelView,
    DivideByScaleSquared,
    NoRenormalisation,
    ZeroNormal,
    TangentsByInverseTranspose,
    TangentsByCofactor,
};

/// What is drawn besides the object.
struct Shown {
    bool ghost = true;          ///< the untransformed object
    bool grid = true;           ///< the ground
    bool axes = true;           ///< the object's axes, by whose ends it is stretched
    bool tangent_plane = true;  ///< at the probe, with the right-angle marks
    bool probe = true;          ///< the probe's own arrows, arc and labels
    bool legend = true;
    bool polygon = false;       ///< H in the probe's plane's place, with its edges, and MH
    bool sheets = false;        ///< the probe's normal as a stack of sheets, and what crosses them
    bool stretch_axes = false;  ///< the perpendicular directions that M only stretches, and the normals it treats worst
    friend bool operator==(const Shown&, const Shown&) = default;
};

/// A plane through the object across one of its axes, on which a formula's f is shown: its level sets f = c, and ∇f.
struct Slice {
    Axis axis = Axis::Z;
    double at = 0.0;       ///< where it cuts the axis, in object space
    bool gradient = true;  ///< with ∇f as arrows that stand on it
    friend bool operator==(const Slice&, const Slice&) = default;
};

/// A ray to be followed from the world to the object's space and back.
struct AimedRay {
    static constexpr int kLastStep = 7;
    /// Empty: from beside the camera, through the middle of the picture.
    std::optional<Point<World>> from, toward;
    int step = kLastStep;  ///< how far it is followed (core/surface/ray_steps.h)
    friend bool operator==(const AimedRay&, const AimedRay&) = default;
};

/// Everything that a user can change, as one value.
struct Scene {
    std::string about;  ///< one line that says what the scene shows
    SurfaceSource surface;
    std::vector<StackEntry> stack;
    /// How many entries of the stack are applied, a fraction meaning part of the next; empty: all.
    std::optional<double> stack_position;
    Rule rule = Rule::InverseTranspose;
    Mistake mistake = Mistake::Naive;
    /// What the naive rule itself is bent to, where it stands in its own place: U Σᵖ Vᵀ n (between_the_rules), −1 … 1.
    double power = 1.0;
    ViewMode view = ViewMode::Overlay;
    Arrows arrows;
    Camera camera;
    /// Where the light comes from; it does not move with the camera.
    Direction<World> light{-25.0, 50.0};
    SurfaceColor color = SurfaceColor::Lit;
    bool renormalise = true;  ///< make interpolated normals unit again at each pixel
    bool cull = false;        ///< leave out triangles whose winding shows their back, as the picture has it
    Theme theme = Theme::Light;
    Shown show;
    /// A point in object space; the probe is the surface's point nearest to it. Empty: what the camera sees nearest
    /// the middle of the picture.
    std::optional<Point<Object>> probe;
    /// Up to so many other points, to be read beside the probe as rows.
    static constexpr std::size_t kMostPinned = 4;
    std::vector<Point<Object>> pinned;
    /// Where ∇f = 0 there is no normal, and a neighbour on the surface lends its own: the one nearest this direction.
    std::optional<Direction<Object>> borrow;
    std::optional<Slice> slice;
    std::optional<AimedRay> ray;

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// The power to which the rule in the naive one's place takes M3's stretch: 1 where that is another mistake.
constexpr double shown_power(const Scene& scene) { return scene.mistake == Mistake::Naive ? scene.power : 1.0; }

/// The arrows that a view shows for the rule that shades it: the scene's own choice, or the default one.
std::vector<ArrowKind> shown_arrows(const Scene& scene, Rule pane_rule);

/// The entries as far as `stack_position`, the last one in part where that is between two.
std::vector<StackEntry> applied_stack(const Scene& scene);

/// M, with everything that follows from it. Throws InputError where the product overflows.
Transform<World, Object> world_from_object(const Scene& scene);

}  // namespace normalscope

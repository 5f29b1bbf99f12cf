#pragma once

// Every key of a scene, declared once: reading, writing, `--set` and the list of known keys all follow from here.

#include "core/base/range.h"
#include "core/scene/scene.h"

#include <array>
#include <concepts>
#include <string_view>
#include <utility>

namespace normalscope {

inline constexpr Range kCoordinate{-1e9, 1e9};
inline constexpr Range kDegrees{-36000.0, 36000.0};
inline constexpr std::size_t kMostStackEntries = 200;

/// How many entries a list may have, and what to do where it has more.
struct AtMost {
    std::size_t count = 200;
    std::string_view of = "entries", remedy = "";
};

template <class E>
using EnumName = std::pair<E, std::string_view>;

inline constexpr std::array kShapeNames{EnumName<Shape>{Shape::Sphere, "sphere"},
                                        EnumName<Shape>{Shape::Cube, "cube"},
                                        EnumName<Shape>{Shape::Cylinder, "cylinder"},
                                        EnumName<Shape>{Shape::Cone, "cone"},
                                        EnumName<Shape>{Shape::Torus, "torus"},
                                        EnumName<Shape>{Shape::Plane, "plane"},
                                        EnumName<Shape>{Shape::Dodecahedron, "dodecahedron"}};
inline constexpr std::array kClipNames{EnumName<Clip>{Clip::Ball, "ball"}, EnumName<Clip>{Clip::Box, "box"}};
inline constexpr std::array kViewNames{
    EnumName<ViewMode>{ViewMode::Single, "single"}, EnumName<ViewMode>{ViewMode::Split, "split"},
    EnumName<ViewMode>{ViewMode::Overlay, "overlay"}, EnumName<ViewMode>{ViewMode::Flat, "flat"}};
inline constexpr std::array kPlacementNames{EnumName<ArrowPlacement>{ArrowPlacement::Vertices, "vertices"},
                                            EnumName<ArrowPlacement>{ArrowPlacement::Faces, "faces"}};
inline constexpr std::array kArrowKindNames{EnumName<ArrowKind>{ArrowKind::Object, "object"},
                                            EnumName<ArrowKind>{ArrowKind::Naive, "naive"},
                                            EnumName<ArrowKind>{ArrowKind::InverseTranspose, "inverse-transpose"},
                                            EnumName<ArrowKind>{ArrowKind::Cofactor, "cofactor"}};
inline constexpr std::array kColorNames{EnumName<SurfaceColor>{SurfaceColor::Lit, "lit"},
                                        EnumName<SurfaceColor>{SurfaceColor::Error, "error"},
                                        EnumName<SurfaceColor>{SurfaceColor::Normals, "normals"}};
inline constexpr std::array kThemeNames{EnumName<Theme>{Theme::Light, "light"}, EnumName<Theme>{Theme::Dark, "dark"},
                                        EnumName<Theme>{Theme::LightContrast, "light-contrast"},
                                        EnumName<Theme>{Theme::DarkContrast, "dark-contrast"}};
inline constexpr std::array kRuleNames{EnumName<Rule>{Rule::Naive, "naive"},
                                       EnumName<Rule>{Rule::InverseTranspose, "inverse-transpose"},
                                       EnumName<Rule>{Rule::Cofactor, "cofactor"}};

inline constexpr std::array kMistakeNames{
    EnumName<Mistake>{Mistake::Naive, "naive"},
    EnumName<Mistake>{Mistake::InversesNotReversed, "inverses-not-reversed"},
    EnumName<Mistake>{Mistake::NotTransposed, "not-transposed"},
    EnumName<Mistake>{Mistake::NotInverted, "not-inverted"},
    EnumName<Mistake>{Mistake::WOne, "w-one"},
    EnumName<Mistake>{Mistake::LeakingTranslation, "leaking-translation"},
    EnumName<Mistake>{Mistake::ModelView, "mat3-model-view"},
    EnumName<Mistake>{Mistake::DivideByScaleSquared, "divide-by-scale-squared"},
    EnumName<Mistake>{Mistake::NoRenormalisation, "no-renormalisation"},
    EnumName<Mistake>{Mistake::ZeroNormal, "zero-normal"},
    EnumName<Mistake>{Mistake::TangentsByInverseTranspose, "tangents-by-inverse-transpose"},
    EnumName<Mistake>{Mistake::TangentsByCofactor, "tangents-by-cofactor"}};

inline constexpr std::array kAxisNames{EnumName<Axis>{Axis::X, "x"}, EnumName<Axis>{Axis::Y, "y"},
                                       EnumName<Axis>{Axis::Z, "z"}};

constexpr const auto& names_of(Axis) { return kAxisNames; }
constexpr const auto& names_of(Mistake) { return kMistakeNames; }
constexpr const auto& names_of(Shape) { return kShapeNames; }
constexpr const auto& names_of(Clip) { return kClipNames; }
constexpr const auto& names_of(ViewMode) { return kViewNames; }
constexpr const auto& names_of(ArrowPlacement) { return kPlacementNames; }
constexpr const auto& names_of(ArrowKind) { return kArrowKindNames; }
constexpr const auto& names_of(SurfaceColor) { return kColorNames; }
constexpr const auto& names_of(Theme) { return kThemeNames; }
constexpr const auto& names_of(Rule) { return kRuleNames; }

template <class S, class T>
concept Is = std::same_as<std::remove_const_t<S>, T>;

// `f(key, value)` and `f(key, value, range)`, for S and const S alike.

template <class F, Is<ShapeSurface> S>
void fields(F& f, S& s) {
    f("shape", s.shape);
    f("resolution", s.resolution, Range{3, 512});
}
template <class F, Is<MeshSurface> S>
void fields(F& f, S& s) {
    f("mesh", s.mesh);
}
/// The parameters' letters; those that the formula does not contain are neither read nor written.
template <class Values>
struct ParametersOf {
    const std::string& formula;
    Values& values;
};
template <class F, Is<FormulaSurface> S>
void fields(F& f, S& s) {
    f("formula", s.formula);
    f("parameters", ParametersOf<std::remove_reference_t<decltype((s.parameters))>>{s.formula, s.parameters});
    f("bound", s.bound, Range{1e-3, 1e3});
    f("clip", s.clip);
}
template <class F, Is<Rotate> S>
void fields(F& f, S& s) {
    f("axis", s.axis, kCoordinate);
    f("degrees", s.degrees, kDegrees);
}
template <class F, Is<Shear> S>
void fields(F& f, S& s) {
    f("xy", s.xy, kCoordinate);
    f("xz", s.xz, kCoordinate);
    f("yx", s.yx, kCoordinate);
    f("yz", s.yz, kCoordinate);
    f("zx", s.zx, kCoordinate);
    f("zy", s.zy, kCoordinate);
}
template <class F, Is<Arrows> S>
void fields(F& f, S& s) {
    f("at", s.at);
    f("every", s.every, Range{1, 1e9});
    f("length", s.length, Range{0.001, 10});
    f("limit", s.limit, Range{0, 1e6});
    f("show", s.show);
}
template <class F, Is<Camera> S>
void fields(F& f, S& s) {
    f("azimuth", s.azimuth, kDegrees);
    f("elevation", s.elevation, Range{-90, 90});
    f("zoom", s.zoom, Range{Camera::kLeastZoom, Camera::kMostZoom});
    f("target", s.target.xyz, kCoordinate);
}
template <class F, class S>
    requires Is<S, Direction<World>> || Is<S, Direction<Object>>
void fields(F& f, S& s) {
    f("azimuth", s.azimuth, kDegrees);
    f("elevation", s.elevation, Range{-90, 90});
}
template <class F, Is<Shown> S>
void fields(F& f, S& s) {
    f("ghost", s.ghost);
    f("grid", s.grid);
    f("axes", s.axes);
    f("tangent_plane", s.tangent_plane);
    f("probe", s.probe);
    f("legend", s.legend);
    f("polygon", s.polygon);
    f("sheets", s.sheets);
    f("stretch_axes", s.stretch_axes);
}
template <class F, Is<Slice> S>
void fields(F& f, S& s) {
    f("axis", s.axis);
    f("at", s.at, kCoordinate);
    f("gradient", s.gradient);
}
template <class F, Is<AimedRay> S>
void fields(F& f, S& s) {
    f("from", s.from);
    f("toward", s.toward);
    f("step", s.step, Range{0, AimedRay::kLastStep});
}
template <class F, Is<Scene> S>
void fields(F& f, S& s) {
    f("about", s.about);
    f("surface", s.surface);
    f("stack", s.stack, AtMost{kMostStackEntries, "entries", ", so multiply some into one matrix"});
    f("stack_position", s.stack_position, Range{0, kMostStackEntries});
    f("rule", s.rule);
    f("mistake", s.mistake);
    f("power", s.power, Range{-1, 1});
    f("view", s.view);
    f("arrows", s.arrows);
    f("camera", s.camera);
    f("light", s.light);
    f("color", s.color);
    f("renormalise", s.renormalise);
    f("cull", s.cull);
    f("theme", s.theme);
    f("show", s.show);
    f("probe", s.probe);
    f("pinned", s.pinned, AtMost{Scene::kMostPinned, "points"});
    f("borrow", s.borrow);
    f("slice", s.slice);
    f("ray", s.ray);
}

}  // namespace normalscope

#pragma once

#include "core/frame/flat_view.h"
#include "core/math/camera.h"
#include "core/math/highlight.h"
#include "core/scene/mistakes.h"
#include "core/scene/palette.h"
#include "core/scene/scene.h"
#include "core/surface/level_sets.h"
#include "core/surface/probe.h"
#include "core/surface/ray_steps.h"
#include "core/surface/singular_point.h"
#include "core/surface/surface.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// In pixels from the top left of the framebuffer.
struct PixelRect {
    glm::ivec2 origin{0};
    glm::ivec2 size{0};
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// How formulas' surfaces are drawn: as well as can be; while something moves, at half the resolution; and while one types,
/// as their mesh where they are new, since a driver takes long to compile their program.
enum class Quality { Fine, Draft, Sketch };

/// The mesh drawn once, by one matrix.
struct SurfaceDraw {
    glm::mat4 world_from_object{1.0f};
    /// Of a formula's surface where M has an inverse: it is met by each pixel's ray, in place of its mesh.
    std::optional<glm::dmat4> traced_object_from_world;
    std::optional<NormalMap> normals;  ///< empty: no normals, so no shading
    /// +1 or −1: what turns the winding that the picture shows into the side that `normals` take for outside. 0: neither
    /// side is.
    float outside = 1.0f;
    glm::vec4 color{1.0f};         ///< alpha below 1: a ghost
    bool yields = false;           ///< where it lies in another surface, that one is seen
    glm::vec3 inside_color{1.0f};  ///< of the back of an open surface
    /// Which triangles are left out: those whose winding in the picture is a back's, or those that truly show the inside,
    /// where nobody can see them.
    enum class Cull { None, PictureBacks, Inside } cull = Cull::None;
    bool mirrored = false;          ///< M reflects: what was counterclockwise is clockwise in the picture
    bool black_where_zero = false;  ///< as NaN would look, where a normal comes out zero
    SurfaceColor shows = SurfaceColor::Lit;
};

/// From so many on each is a few pixels, and all are drawn plain.
inline constexpr std::size_t kManyArrows = 20'000;

/// A shape of its own for each kind of arrow, for whom colours look alike; the legend's are the same.
enum class ArrowLook { Plain, Dashed, Hollow, TwoHeads };
constexpr ArrowLook arrow_look(ArrowKind kind) {
    switch (kind) {
        case ArrowKind::Object: return ArrowLook::Hollow;
        case ArrowKind::Naive: return ArrowLook::Dashed;
        case ArrowKind::Cofactor: return ArrowLook::TwoHeads;
        case ArrowKind::InverseTranspose: break;
    }
    return ArrowLook::Plain;
}

/// The surface's arrows drawn once: bases by one matrix, directions by another, length and radius in world units.
struct ArrowDraw {
    glm::mat4 world_from_object{1.0f};
    NormalMap normals;
    glm::vec3 color{1.0f};
    float length = 0.1f;
    float radius = 0.01f;
    ArrowLook look = ArrowLook::Plain;
    /// A ball in world space, centre and radius, in which none stands: the probe's own arrows do.
    glm::vec4 cleared{0.0f};
};

/// Base and tip of an arrow in world space, where scene.vert puts it; empty where there is none.
std::optional<std::array<glm::dvec3, 2>> ends_of(const ArrowDraw& draw, const Site& site);

/// Corner of a triangle in world space, for what is made anew every frame: the probe's arrows and marks, the axes.
struct SolidVertex {
    glm::vec3 position;
    glm::vec3 normal;  ///< zero: not lit
    glm::vec4 color;
};

/// What a symbol of the equations is in the picture: pointing at one lights up the other.
struct SymbolArrow {
    Highlight what;
    glm::dvec3 base{0.0}, vector{0.0};  ///< in world space
    glm::vec3 color{1.0f};
};

/// Text beside a place in the picture.
struct Label {
    /// A side and a level name parts of a plane, on which they stand in boxes of their own.
    enum class Role { Title, Axis, Note, Side, Level } role = Role::Note;
    glm::vec2 pixel{0.0f};  ///< what it belongs to, from the top left of the framebuffer
    std::string text;
    glm::vec3 color{0.0f};
};

/// A line or an arrow in world space, on which no word lies.
struct Stroke {
    glm::dvec3 a{0.0}, b{0.0};
    double half_width = 0.0;  ///< in world units
};

/// A word that stands near a place of world space, wherever it hides the least (core/frame/label_room.h).
struct WantedLabel {
    glm::dvec3 at{0.0};
    std::string text;
    glm::vec3 color{0.0f};
    bool there = false;  ///< rather about its very place than beside it
};

struct LegendEntry {
    ArrowKind kind;
    ArrowLook look;  ///< in pixels; an SVG's arrows have their own in any number
    std::string text;
    glm::vec3 color;
};

/// What a surface's colours stand for where it is not lit.
struct ColorKey {
    SurfaceColor of = SurfaceColor::Error;
    std::string text;  ///< "naive rule’s error"
};

/// What the error map compares at each place: the map that is shown in the naive rule's place, and the matrix that the
/// tangent plane (n, −n·p) goes by. Its 3×3 part is all that counts where M is affine.
struct ErrorMaps {
    NormalMap shown;
    glm::dmat4 planes{1.0};
};

/// One view of the scene: the whole picture, or the half that shows one rule.
struct Pane {
    PixelRect rect;
    Rule rule = Rule::InverseTranspose;
    CameraView view;
    std::vector<SurfaceDraw> surfaces;  ///< opaque ones before ghosts
    std::vector<ArrowDraw> arrows;
    std::vector<SolidVertex> solids;       ///< opaque triangles
    std::vector<SolidVertex> translucent;  ///< drawn last, without writing depth
    std::vector<Label> labels;
    std::vector<SymbolArrow> symbols;  ///< at the probe, drawn or not
    std::vector<Stroke> strokes;
    std::vector<std::vector<glm::dvec3>> areas;  ///< convex, in world space: words stand beside them where they can
    std::vector<WantedLabel> wanted;             ///< none are left in a frame that is made
    std::vector<glm::dvec2> outline;             ///< convex, in pixels of the pane, about the object
};

/// A picture as data: what a renderer draws and what the overlay writes on it. Colours are sRGB.
struct Frame {
    PixelRect rect;
    Theme theme = Theme::Light;
    std::shared_ptr<const Surface> surface;
    std::vector<Pane> panes;
    glm::vec3 toward_light{0.0f, 1.0f, 0.0f};
    std::optional<ErrorMaps> error_maps;  ///< empty where there is nothing to compare
    double unit = 1.0;                    ///< what is long in the picture beside a large or small object (picture_unit)
    std::optional<glm::vec3> plain_ground;  ///< behind everything, in place of the theme's ground
    std::optional<float> ground_height;     ///< of the grid; empty: no grid
    glm::mat3 shadow_from_ground{0.0f};     ///< (x, z, 1) to a disc that is 1 where the object's shadow ends
    std::vector<LegendEntry> legend;
    /// Where that may stand: of a picture that moves it keeps its corner.
    enum class LegendCorner { LowerLeft, WhereFree } legend_corner = LegendCorner::LowerLeft;
    std::optional<ColorKey> color_key;
    Quality quality = Quality::Fine;
    std::optional<ProbeInWorld> probe;
    std::vector<std::optional<ProbeInWorld>> pinned;  ///< the scene's; empty where a point is not there
    std::optional<SingularPoint> singular;            ///< where the probe stands on one
    bool fan = false;                                 ///< and more of the normals around it are drawn than two
    std::optional<RaySteps> ray;                      ///< the scene's
    std::vector<std::string> notes;                   ///< on what is drawn: what is not as one may expect
    std::optional<FlatView> flat;                     ///< where the view is flat
};

/// Where the arc of the angle, the legend's swatches and the map's key take their colour: error in degrees, 0 … 90.
glm::vec3 error_color(double degrees);

}  // namespace normalscope

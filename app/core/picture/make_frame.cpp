#include "core/picture/make_frame.h"

#include "core/frame/drawn_arrows.h"
#include "core/frame/label_room.h"
#include "core/frame/picture_scale.h"
#include "core/frame/solids.h"
#include "core/picture/decomposition_marks.h"
#include "core/picture/derivation_marks.h"
#include "core/picture/flat_marks.h"
#include "core/picture/framing.h"
#include "core/picture/ground.h"
#include "core/picture/handle_marks.h"
#include "core/picture/pinned_marks.h"
#include "core/picture/polygon_marks.h"
#include "core/picture/probe_marks.h"
#include "core/picture/ray_marks.h"
#include "core/picture/sheet_marks.h"
#include "core/picture/singular_marks.h"
#include "core/picture/slice_marks.h"
#include "core/picture/step_labels.h"
#include "core/picture/way_of_drawing.h"
#include "core/surface/face_polygon.h"
#include "core/surface/surface_probe.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

using WorldFromObject = Transform<World, Object>;

// Where only directions count, bring the entries near 1, so that floats neither overflow nor vanish.
NormalMap scaled_for_floats(NormalMap map) {
    if (map.at_vertices == NormalMap::UnitLength::No && !map.at_pixels) {
        map.matrix = drawable(map.matrix);
        return map;
    }
    double largest = 0.0;
    for (int c = 0; c < 4; ++c) largest = std::max(largest, glm::length(glm::dvec3(map.matrix[c])));
    if (largest > 0.0) map.matrix /= largest;
    return map;
}

std::vector<Pane> empty_panes(const Scene& scene, const PixelRect& rect) {
    if (scene.view != ViewMode::Split) return {Pane{rect, scene.rule, CameraView(scene.camera, rect.size)}};
    const int left = rect.size.x / 2;
    const PixelRect halves[]{{rect.origin, {left, rect.size.y}},
                             {rect.origin + glm::ivec2(left, 0), {rect.size.x - left, rect.size.y}}};
    std::vector<Pane> panes;
    for (const Rule rule : pane_rules(scene)) {
        const PixelRect& half = halves[panes.size()];
        panes.push_back(Pane{half, rule, CameraView(scene.camera, glm::max(half.size, glm::ivec2(1)))});
    }
    return panes;
}

/// What a picture's surfaces are drawn with besides the scene.
struct SurfaceOptions {
    bool ghost, sliced;
    Quality quality;
    double right_power;
};

void add_surfaces(Pane& pane, const Scene& scene, const Surface& surface, const WorldFromObject& m,
                  const SurfaceOptions& options) {
    const ThemeColors colors = theme_colors(scene.theme);
    SurfaceDraw object;
    object.world_from_object = drawable(m.matrix());
    // What would hide a slice is of glass.
    object.color = glm::vec4(colors.surface, options.sliced ? 0.5f : 1.0f);
    const bool traced = is_traced(surface);
    // Where M is not affine a ray may come back from infinity in object space: then its mesh is drawn, and that is said.
    if (const auto back = m.inverse(); back && traced && m.affine()) object.traced_object_from_world = back->matrix();
    if (const auto map = normal_map(scene, m, pane.rule, options.right_power)) object.normals = scaled_for_floats(*map);
    if (scene.cull)
        object.cull = SurfaceDraw::Cull::PictureBacks;
    else if (surface.mesh.closed && m.rank() == 3)
        object.cull = SurfaceDraw::Cull::Inside;
    object.mirrored = m.reflects();
    object.black_where_zero = scene.mistake == Mistake::ZeroNormal && pane.rule == Rule::Naive;
    // A reflection turns the picture's winding over. The gradient's outside stays; the cofactor's turns with it.
    object.outside = m.reflects() && pane.rule != Rule::Cofactor ? -1.0f : 1.0f;
    // Flattened, front and back lie in the same place, and neither is an inside. Their naive normals are the same, too:
    // turning one over would make them flicker. The cofactor's are opposite, and each belongs to its winding.
    if (m.rank() < 3 && pane.rule != Rule::Cofactor) object.outside = 0.0f;
    object.inside_color = m.rank() < 3 ? colors.surface : colors.inside;
    object.shows = scene.color;
    pane.surfaces.push_back(object);
    if (!options.ghost) return;
    SurfaceDraw shell;
    if (traced && options.quality == Quality::Fine) shell.traced_object_from_world = glm::dmat4(1.0);
    shell.cull = SurfaceDraw::Cull::Inside;
    shell.normals = NormalMap{};
    shell.color = glm::vec4(colors.ghost, 0.55f);
    shell.yields = true;
    pane.surfaces.push_back(shell);
}

// Whether the naive rule's arrows, or whatever stands in its place, lie in the right ones.
bool coincide(const Scene& scene, const WorldFromObject& m, double right_power) {
    const auto a = normal_map(scene, m, Rule::Naive), b = normal_map(scene, m, Rule::InverseTranspose, right_power);
    if (!a || !b || a->w != 0.0) return false;
    const double la = largest_entry(glm::dmat3(a->matrix)), lb = largest_entry(glm::dmat3(b->matrix));
    return la > 0.0 && lb > 0.0 && largest_entry(glm::dmat3(a->matrix) / la - glm::dmat3(b->matrix) / lb) < 1e-9;
}

void add_arrows(Pane& pane, const Scene& scene, const WorldFromObject& m, const std::optional<ProbeInWorld>& probe,
                const FrameOptions& options) {
    const double cleared = probe ? cleared_by_probe(pane, scene, *probe, options) : 0.0;
    const std::vector<ArrowKind> kinds = drawn_arrows(scene, m, pane.rule);
    // Of two that lie in one place both are seen: the dashes go around the other's shaft.
    const bool around =
        std::ranges::count(kinds, ArrowKind::InverseTranspose) > 0 && coincide(scene, m, options.right_power);
    const auto widened = [&](ArrowKind kind) {
        return kind == ArrowKind::Object            ? ArrowProportions::kOfObject
               : kind == ArrowKind::Naive && around ? ArrowProportions::kAround
                                                    : 1.0f;
    };
    const auto draw = [&](const glm::dmat4& points, const NormalMap& normals, ArrowKind kind) {
        const float scale = kind == ArrowKind::Object ? 1.0f : static_cast<float>(options.unit);
        const float of_unit = static_cast<float>(2.0 * scene.arrows.length);  // in diameters of the unit ball
        const float length = scale * of_unit, radius = scale * std::clamp(0.042f * of_unit, 0.003f, 0.025f);
        pane.arrows.push_back({drawable(points),
                               scaled_for_floats(normals),
                               arrow_color(kind, scene.theme),
                               length,
                               widened(kind) * radius,
                               arrow_look(kind),
                               {}});
        if (probe)
            pane.arrows.back().cleared = {
                glm::vec3(kind == ArrowKind::Object ? probe->object.point.xyz : probe->point.xyz),
                static_cast<float>(cleared)};
    };
    for (const ArrowKind kind : kinds) {
        if (kind == ArrowKind::Object) {
            if (scene.show.ghost) draw(glm::dmat4(1.0), {}, kind);
        } else if (const auto map =
                       normal_map(scene, m, kRules[static_cast<std::size_t>(kind) - 1], options.right_power)) {
            draw(m.matrix(), *map, kind);
        }
    }
}

void keep_clear_of_arrows(Pane& pane, std::span<const Site> sites) {
    if (sites.size() > kFewArrows) return;
    for (const ArrowDraw& draw : pane.arrows)
        for (const Site& site : sites)
            if (const auto ends = ends_of(draw, site))
                keep_clear(pane, *ends, ArrowProportions::kHeadRadius * draw.radius);
}

void add_legend(Frame& frame, const Scene& scene, const WorldFromObject& m) {
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const InNaivePlace in_place = in_naive_place(scene);
    const bool probe = frame.probe && scene.show.probe;  // whose arrows are there one by one
    if (scene.color == SurfaceColor::Error && frame.error_maps)
        frame.color_key = {SurfaceColor::Error,
                           plainly_naive(scene) ? "naive rule’s error" : "error: " + in_place.title};
    else if (scene.color == SurfaceColor::Normals)
        frame.color_key = {SurfaceColor::Normals, "normals: n·½ + ½ as red, green, blue"};
    for (const ArrowKind kind : kArrowKinds) {
        const bool shown = std::ranges::any_of(frame.panes, [&](const Pane& pane) {
            return std::ranges::count(drawn_arrows(scene, m, pane.rule), kind) > 0;
        });
        if (!shown || (kind == ArrowKind::Object && !scene.show.ghost)) continue;
        // Each half's title names its own.
        if (scene.view == ViewMode::Split &&
            std::ranges::any_of(frame.panes, [&](const Pane& pane) { return arrow_kind(pane.rule) == kind; }))
            continue;
        std::string text = "n of the object";
        if (kind != ArrowKind::Object) {
            const Rule rule = kRules[static_cast<std::size_t>(kind) - 1];
            const ByRule<std::string_view> titles{in_place.title, "inverse transpose", "cofactor"};
            text = std::string(titles[rule]) + "  " +
                   (rule == Rule::Naive ? in_place.formula : std::string(formula(rule)));
            if (!matrices.by(rule) || (rule == Rule::Naive && !between_the_rules(matrices, shown_power(scene))))
                text += "  does not exist";
            else if (rule == Rule::Cofactor && matrices.rank < 2)
                text += "  is zero";
            else if (!m.affine())
                text += "  approximate: M is not affine";
        }
        const bool plain = frame.surface->arrows.size() >= kManyArrows && !probe;
        frame.legend.push_back(
            {kind, plain ? ArrowLook::Plain : arrow_look(kind), text, arrow_color(kind, scene.theme)});
    }
    if (!m.affine() && probe && frame.probe->truth)
        frame.legend.emplace_back(ArrowKind::InverseTranspose, ArrowLook::Plain, "the normal, by (M⁻¹)ᵀ (n, −n·p)",
                                  theme_colors(scene.theme).text);
}

// What gives the normals of this half.
void add_title(Pane& pane, const Scene& scene) {
    const InNaivePlace in_place = in_naive_place(scene);
    const ByRule<std::string> titles{plainly_naive(scene) ? "Naive" : in_place.title, "Inverse transpose", "Cofactor"};
    pane.labels.push_back(
        {Label::Role::Title, glm::vec2(pane.rect.origin) + glm::vec2(0.5f * static_cast<float>(pane.rect.size.x), 0.0f),
         titles[pane.rule] + "   " + (pane.rule == Rule::Naive ? in_place.formula : std::string(formula(pane.rule))),
         rule_color(pane.rule)});
}

// What is drawn in the scene's place: with a zoom where it says none, and with less where all of it would be too much: from
// within the ghost, and where the derivation shows arrows of its own.
std::optional<Scene> drawn_instead(const Scene& scene, const Surface& surface, bool derives) {
    constexpr double kInTheWay = 0.02;  // of the ghost's size: so near to it, it is everywhere
    Scene less = with_zoom(scene, surface);
    if (less.camera.reach() < kInTheWay) less.show.ghost = false;
    if (derives) {
        less.show.probe = less.show.tangent_plane = less.show.sheets = less.show.legend = false;
        less.arrows.show = std::vector<ArrowKind>{};
    }
    return less == scene ? std::nullopt : std::optional(std::move(less));
}

// Where the probe is, the points that are kept beside it, and where the ray goes.
void find_probe(Frame& frame, const Scene& scene, const WorldFromObject& m, double right_power) {
    const Surface& surface = *frame.surface;
    const Pane& pane = frame.panes.front();
    auto probe = scene.probe ? nearest_probe(surface, *scene.probe, scene.borrow)
                             : probe_in_view(surface, m, pane.view, 0.5 * glm::dvec2(pane.rect.size), scene.borrow);
    if (probe && !m.reaches(probe->point)) probe.reset();
    if (probe && scene.show.polygon) probe = with_polygon(*probe, surface);
    if (probe) frame.probe = in_world(*probe, m, scene, right_power);
    if (probe && probe->singular) frame.singular = singular_point(*surface.implicit, probe->point, scene.borrow);
    frame.pinned = pinned_probes(scene, surface, m, right_power);
    if (scene.ray) frame.ray = ray_steps(scene, surface, m, pane.view);
}

}  // namespace

Frame make_frame(const Scene& scene, std::shared_ptr<const Surface> surface, const FrameOptions& given) {
    const WorldFromObject m = world_from_object(scene);
    // Where there is no inverse transpose, the derivation has no arrows to carry.
    const bool derives = given.marks.line && m.affine() && m.rank() == 3;
    if (const auto other = drawn_instead(scene, *surface, derives))
        return make_frame(*other, std::move(surface), given);
    FrameOptions options = given;
    if (!derives) options.marks.line.reset();
    // Within a large object, or close to it, arrows and marks as large as that would be all that one sees.
    options.unit = std::min(picture_unit(*surface, m), std::max(1.0, scene.camera.reach()));

    Frame frame;
    frame.unit = options.unit;
    frame.rect = options.rect;
    frame.quality = options.quality;
    frame.theme = scene.theme;
    frame.surface = std::move(surface);
    frame.toward_light = scene.light.vector().xyz;
    if (const auto shown = normal_map(scene, m, Rule::Naive); shown && m.inverse()) {
        const glm::dmat4 planes = m.affine() ? glm::dmat4(*m.normal_matrices_by_rule().inverse_transpose) : *m.planes();
        frame.error_maps = {scaled_for_floats(*shown), scaled_for_floats({.matrix = planes}).matrix};
    }
    // At rest on the object, the ghost would only flicker.
    const bool ghost = scene.show.ghost && (scene.view == ViewMode::Overlay || scene.ray || options.marks.line) &&
                       m.matrix() != glm::dmat4(1.0);
    if (scene.view == ViewMode::Flat) {
        frame.panes = empty_panes(scene, options.rect);
        add_flat_view(frame, scene, m, options);
        if (scene.show.legend) add_legend(frame, scene, m);
        add_step_labels(frame.panes.front(), scene, m, options);
        end_flat_view(frame, options);
        place_labels(frame.panes.front(), *frame.surface, m, options.pixel_scale);
        return frame;
    }
    if (scene.show.grid) frame.ground_height = ground_height(frame.surface->mesh, m, ghost, options.unit);
    frame.shadow_from_ground = shadow_from_ground(*frame.surface, m, options.unit);
    frame.panes = empty_panes(scene, options.rect);
    for (Pane& pane : frame.panes) pane.view = pane.view.reaching(farthest_depth(*frame.surface, m, pane.view));

    find_probe(frame, scene, m, options.right_power);
    const std::shared_ptr<const LevelSets> slice =
        options.level_sets ? options.level_sets : level_sets(scene, frame.surface->implicit.get());
    for (Pane& pane : frame.panes) {
        add_surfaces(pane, scene, *frame.surface, m, {ghost, slice != nullptr, options.quality, options.right_power});
        if (slice) add_slice(pane, scene, *slice, m, ghost, options);
        add_arrows(pane, scene, m, frame.probe, options);
        keep_clear_of_arrows(pane, frame.surface->arrows);
        if (scene.show.axes) add_axes(pane, scene, frame.surface->extent, options);
        if (frame.probe) add_polygon_marks(pane, scene, *frame.probe, ghost, options);
        if (frame.probe) add_probe_marks(pane, scene, *frame.probe, drawn_arrows(scene, m, pane.rule), options);
        if (frame.probe && options.marks.line) add_derivation_marks(pane, scene, *frame.probe, m, options);
        add_sheet_marks(pane, scene, frame, m, ghost, options);
        if (frame.singular && add_singular_marks(pane, scene, *frame.singular, m, options)) frame.fan = true;
        if (options.handles) add_knobs(pane, scene, m, options);
        if (frame.ray) add_ray_marks(pane, scene, *frame.ray, m, ghost, options);
        if (scene.show.stretch_axes) add_decomposition_marks(pane, scene, frame.surface->mesh, m, options);
        add_pinned_marks(pane, scene, frame, options);
        add_step_labels(pane, scene, m, options);
        if (scene.view == ViewMode::Split) add_title(pane, scene);
        place_labels(pane, *frame.surface, m, options.pixel_scale);
    }
    if (scene.show.legend) add_legend(frame, scene, m);
    frame.notes = frame.surface->mesh.notes;
    if (const std::string_view note = note_on_triangles(*frame.surface, m); !note.empty())
        frame.notes.emplace_back(note);
    if (const auto& positions = frame.surface->mesh.positions;
        !m.affine() && !positions.empty() &&
        std::ranges::none_of(positions, [&](const glm::dvec3& p) { return m.reaches({p}); }))
        frame.notes.emplace_back(
            "No point of the surface has an image under M: w is 0 or negative on all of it. Nothing of the object is "
            "drawn.");
    return frame;
}

}  // namespace normalscope

#include "gl/renderer.h"

#include "core/math/projective.h"
#include "core/picture/drawn_box.h"
#include "gl/arrow_field.h"
#include "gl/programs.h"
#include "gl/rectangles.h"
#include "gl/tracer.h"
#include "gl/vertex_data.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

namespace normalscope {

namespace {

// Where the bound framebuffer's samples lie in a pixel, from its lower left; none where it has just one.
std::vector<glm::vec2> sample_places() {
    GLint count = 0;
    glGetIntegerv(GL_SAMPLES, &count);
    std::vector<glm::vec2> places(count > 1 ? static_cast<std::size_t>(count) : 0);
    for (std::size_t k = 0; k < places.size(); ++k)
        glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(k), &places[k].x);
    return places;
}

}  // namespace

/// What lives on the GPU: programs and vertices, of which the surface's are kept until another surface comes.
struct Renderer::Resources {
    std::optional<BackdropProgram> backdrop_program;
    std::optional<ResolvingProgram> resolving_program;
    SceneProgram scene_program;
    std::optional<SceneProgram> arrow_field_program;
    std::map<std::string, SurfaceProgram> surface_programs;  // by what they define; compiled when first wanted
    std::map<std::string, TracedProgram> traced_programs;
    std::optional<Tracer> tracer;
    int draft_coarseness = 2;
    PaneVertices backdrop;
    SolidVertices solids;

    std::shared_ptr<const Surface> surface;
    std::optional<MeshVertices> mesh;
    std::map<ArrowLook, ArrowVertices> arrows;  // made when first wanted
    std::optional<ArrowField> arrow_field;      // in place of those, where there are a great many

    void hold(const std::shared_ptr<const Surface>& wanted) {
        if (surface == wanted) return;
        mesh.emplace(wanted->mesh);
        arrows.clear();
        arrow_field.reset();
        if (wanted->arrows.size() >= kManyArrows) arrow_field.emplace(wanted->arrows);
        surface = wanted;
    }

    /// And over it the target's samples, if there are any.
    void draw_backdrop(const Frame& frame, const Pane& pane, const Target& target);
    void draw_backdrop(const BackdropProgram& program, const Frame& frame, const Pane& pane);
    void draw_pane(const Frame& frame, const Pane& pane);
    void draw_surface(const Frame& frame, const Pane& pane, const SurfaceDraw& draw);
    void draw_traced(const Frame& frame, const Pane& pane, const SurfaceDraw& draw);
    void draw_arrows(const Frame& frame, const Pane& pane);
    void draw_solids(const Frame& frame, const Pane& pane, const std::vector<SolidVertex>& vertices);

private:
    // Of its distance from the eye: more than facets and rounding make of one place.
    static constexpr double kYields = 6e-4;
    void begin(const SceneProgram& program, const Frame& frame, const Pane& pane) const;
    static void set_normals(const SceneProgram& program, const NormalMap& normals);
    static void set_look(const SceneProgram& program, const Pane& pane, const SurfaceDraw& draw);
    static void set_error_maps(const SurfaceProgram& program, const Frame& frame);
};

namespace {

// What the program of a surface's shaders defines; nothing for the one that is always there.
std::string defines(const Frame& frame, const SurfaceDraw& draw) {
    std::string result;
    if (draw.shows == SurfaceColor::Error && frame.error_maps) result = "ERROR_MAP";
    if (draw.shows == SurfaceColor::Normals) result = "NORMALS";
    if (!is_affine(glm::dmat4(draw.world_from_object)))
        result += (result.empty() ? "" : "\n#define ") + std::string("PROJECTIVE");
    return result;
}

}  // namespace

void Renderer::Resources::begin(const SceneProgram& program, const Frame& frame, const Pane& pane) const {
    program.use();
    program.clip_from_world = pane.view.clip_from_world();
    program.eye = pane.view.eye().xyz;
    program.toward_light = frame.toward_light;
    program.ghost = 0.0f;
    program.arrow_length = 0.0f;
    program.outside = 0.0f;
    program.color_coded = 1.0f;
    program.zero_is_black = 0.0f;
    program.tint = glm::vec4(0.0f);
}

void Renderer::Resources::set_normals(const SceneProgram& program, const NormalMap& normals) {
    program.normal_matrix = normals.matrix;
    program.normal_w = static_cast<float>(normals.w);
    program.unit_at_vertices = static_cast<float>(normals.at_vertices);
    program.unit_at_pixels = normals.at_pixels ? 1.0f : 0.0f;
}

void Renderer::Resources::set_look(const SceneProgram& program, const Pane& pane, const SurfaceDraw& draw) {
    if (draw.yields) program.clip_from_world = glm::mat4(pane.view.clip_from_world_behind(kYields));
    set_normals(program, draw.normals.value_or(NormalMap{.matrix = glm::dmat4(0.0)}));
    program.zero_is_black = draw.black_where_zero ? 1.0f : 0.0f;
    program.outside = draw.outside;
    program.color_coded = 0.0f;
    program.inside_color = draw.inside_color;
    program.ghost = draw.color.a < 1.0f ? 1.0f : 0.0f;
}

void Renderer::Resources::set_error_maps(const SurfaceProgram& program, const Frame& frame) {
    const auto& [shown, planes] = *frame.error_maps;
    program.naive_matrix = shown.matrix;
    program.naive_w = static_cast<float>(shown.w);
    program.inverse_transpose_matrix = glm::dmat3(planes);
    program.planes = planes;
    program.ramp = std::span<const glm::vec3>(kErrorRamp);
}

void Renderer::Resources::draw_backdrop(const BackdropProgram& program, const Frame& frame, const Pane& pane) {
    const ThemeColors colors = theme_colors(frame.theme);
    program.use();
    program.world_from_clip = glm::mat4(glm::inverse(pane.view.clip_from_world()));
    program.ray_depth = static_cast<float>(pane.view.ray_depth());
    program.eye = pane.view.eye().xyz;
    program.top_color = frame.plain_ground.value_or(colors.background_top);
    program.bottom_color = frame.plain_ground.value_or(colors.background_bottom);
    program.grid_color = colors.grid;
    program.ground = frame.ground_height.value_or(0.0f);
    program.unit = static_cast<float>(frame.unit);
    program.grid_amount = frame.ground_height ? 1.0f : 0.0f;
    program.shadow = frame.shadow_from_ground;
    backdrop.draw();
}

void Renderer::Resources::draw_backdrop(const Frame& frame, const Pane& pane, const Target& target) {
    // Where all of a pixel is written, Mesa compiles the shader a second time for tiles that are wholly covered.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    const PixelRect rect = upright(pane.rect, target);
    look_at(rect);
    // A picture by itself is not worth another program. From the second on, what has no samples does without theirs.
    const bool apart = target.samples() == 1 || resolving_program;
    if (apart && !backdrop_program) backdrop_program.emplace();
    if (target.samples() == 1) {
        draw_backdrop(*backdrop_program, frame, pane);
    } else {
        if (!resolving_program) resolving_program.emplace();
        const PixelRect sampled = upright(target.sampled(), target);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, target.sample_colors());
        const PixelRect within = apart ? common(rect, sampled) : rect;
        scissor(within);
        resolving_program->use();
        resolving_program->samples = target.samples();
        resolving_program->drawn_low = sampled.origin;
        resolving_program->drawn_size = sampled.size;
        draw_backdrop(*resolving_program, frame, pane);
        if (apart)
            for (const PixelRect& strip : around(rect, within)) {
                scissor(strip);
                draw_backdrop(*backdrop_program, frame, pane);
            }
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Renderer::Resources::draw_surface(const Frame& frame, const Pane& pane, const SurfaceDraw& draw) {
    const bool as_mesh = frame.quality == Quality::Sketch && !(tracer && tracer->ready(*frame.surface->implicit));
    if (draw.traced_object_from_world && !as_mesh) return draw_traced(frame, pane, draw);
    const std::string wanted = defines(frame, draw);
    const SceneProgram* program = &scene_program;
    if (!wanted.empty()) program = &surface_programs.try_emplace(wanted, wanted).first->second;
    begin(*program, frame, pane);
    if (draw.shows == SurfaceColor::Error && frame.error_maps) set_error_maps(surface_programs.at(wanted), frame);
    set_look(*program, pane, draw);
    program->world_from_object = draw.world_from_object;
    program->tint = draw.color;
    if (draw.cull != SurfaceDraw::Cull::None) glEnable(GL_CULL_FACE);
    glCullFace(draw.cull == SurfaceDraw::Cull::Inside && draw.mirrored ? GL_FRONT : GL_BACK);
    mesh->draw();
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
}

void Renderer::Resources::draw_traced(const Frame& frame, const Pane& pane, const SurfaceDraw& draw) {
    const bool fine = frame.quality == Quality::Fine;
    const int coarseness = fine ? 1 : draft_coarseness;
    std::vector<glm::vec2> shifts;
    if (fine) shifts = sample_places();
    for (glm::vec2& place : shifts) place -= 0.5f;
    if (!tracer) tracer.emplace();
    const std::string wanted = defines(frame, draw);
    const TracedProgram& program = traced_programs.try_emplace(wanted, wanted).first->second;
    tracer->trace(*frame.surface->implicit, pane.view, (pane.rect.size + coarseness - 1) / coarseness,
                  *draw.traced_object_from_world, shifts);

    begin(program, frame, pane);
    set_look(program, pane, draw);
    if (draw.shows == SurfaceColor::Error && frame.error_maps) set_error_maps(program, frame);
    program.tint = draw.color;
    program.space_from_clip = glm::mat4(glm::inverse(pane.view.clip_from_world()));
    program.ray_depth = static_cast<float>(pane.view.ray_depth());
    program.object_from_world = glm::mat3(*draw.traced_object_from_world);
    program.mirrored = draw.mirrored ? 1.0f : 0.0f;
    std::array<GLint, 4> viewport{}, scissor{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glGetIntegerv(GL_SCISSOR_BOX, scissor.data());
    program.pane_origin = glm::ivec2(viewport[0], viewport[1]);
    const PixelRect& box = tracer->box();
    glScissor(viewport[0] + coarseness * box.origin.x, viewport[1] + coarseness * box.origin.y, coarseness * box.size.x,
              coarseness * box.size.y);
    program.hits = 0;
    program.coarseness = coarseness;
    program.edges = 1;
    program.tiles = 2;
    const auto bind = [](GLenum unit, GLuint texture) {
        glActiveTexture(unit);
        glBindTexture(GL_TEXTURE_2D, texture);
    };
    bind(GL_TEXTURE2, tracer->tiles().id());
    bind(GL_TEXTURE1, (shifts.empty() ? tracer->centres() : tracer->samples(0)).id());
    bind(GL_TEXTURE0, tracer->centres().id());
    program.leave_edges = shifts.empty() ? 0.0f : 1.0f;
    program.shift = glm::vec2(0.0f);
    program.tile_size = Tracer::kTile;
    program.tile = tracer->tile();
    program.least = Tracer::kEmpty;
    tracer->draw_tiles();

    program.leave_edges = 0.0f;
    program.least = Tracer::kNoEdge;
    if (!shifts.empty()) glEnable(GL_SAMPLE_MASK);
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        bind(GL_TEXTURE0, tracer->samples(k).id());
        glSampleMaski(0, 1u << k);
        program.shift = 2.0f * shifts[k] / glm::vec2(pane.rect.size);
        tracer->draw_tiles();
    }
    glSampleMaski(0, ~0u);
    glDisable(GL_SAMPLE_MASK);
    glScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
}

void Renderer::Resources::draw_arrows(const Frame& frame, const Pane& pane) {
    if (pane.arrows.empty()) return;
    if (arrow_field && !arrow_field_program) arrow_field_program.emplace("LIT_AT_VERTICES");
    const SceneProgram& program = arrow_field ? *arrow_field_program : scene_program;
    begin(program, frame, pane);
    glEnable(GL_CULL_FACE);
    const auto draw_all = [&](const ArrowDraw& draw, float length) {
        program.arrow_length = length;
        if (arrow_field)
            arrow_field->draw(program, draw, pane.view);
        else
            arrows.try_emplace(draw.look, surface->arrows, draw.look).first->second.draw();
    };
    for (const ArrowDraw& draw : pane.arrows) {
        program.world_from_object = draw.world_from_object;
        set_normals(program, draw.normals);
        program.tint = glm::vec4(draw.color, 1.0f);
        program.paper = theme_colors(frame.theme).background_top;
        program.shaft_radius = draw.radius;
        program.cleared = draw.cleared;
        const float head =
            std::min(ArrowProportions::kHeadLength * draw.radius, ArrowProportions::kLongestHead * draw.length);
        program.head_length = head;
        draw_all(draw, draw.length);
        if (draw.look == ArrowLook::TwoHeads && !(arrow_field && !arrow_field->has_heads()))
            draw_all(draw, draw.length - ArrowProportions::kToSecondHead * head);
    }
    glDisable(GL_CULL_FACE);
}

void Renderer::Resources::draw_solids(const Frame& frame, const Pane& pane, const std::vector<SolidVertex>& vertices) {
    begin(scene_program, frame, pane);
    scene_program.world_from_object = glm::mat4(1.0f);
    set_normals(scene_program, {});
    solids.draw(vertices);
}

Renderer::Renderer() : resources_(std::make_unique<Resources>()) {}
Renderer::~Renderer() = default;

void Renderer::Resources::draw_pane(const Frame& frame, const Pane& pane) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    for (const SurfaceDraw& draw : pane.surfaces)
        if (draw.color.a >= 1.0f) draw_surface(frame, pane, draw);
    glEnable(GL_CULL_FACE);
    draw_solids(frame, pane, pane.solids);
    glDisable(GL_CULL_FACE);
    draw_arrows(frame, pane);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    for (const SurfaceDraw& draw : pane.surfaces)
        if (draw.color.a < 1.0f) draw_surface(frame, pane, draw);
    draw_solids(frame, pane, pane.translucent);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
}

void Renderer::coarsen_drafts(bool more) { resources_->draft_coarseness = more ? 3 : 2; }

void Renderer::draw(const Frame& frame, Target& target) {
    resources_->hold(frame.surface);
    if (target.samples() > 1) {
        PixelRect box;
        for (const Pane& pane : frame.panes) box = united(box, drawn_box(*frame.surface, pane));
        target.bind_samples(box);
        const glm::ivec2 origin = upright(box, target).origin;
        glEnable(GL_SCISSOR_TEST);
        for (const Pane& pane : frame.panes) {
            PixelRect rect = upright(pane.rect, target);
            rect.origin -= origin;
            look_at(rect);
            resources_->draw_pane(frame, pane);
        }
    }
    draw_again(frame, target);
}

void Renderer::draw_again(const Frame& frame, Target& target) {
    target.bind_picture();
    glDisable(GL_SCISSOR_TEST);
    const glm::vec3 beside = theme_colors(frame.theme).panel;
    glClearColor(beside.r, beside.g, beside.b, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    for (const Pane& pane : frame.panes) {
        resources_->draw_backdrop(frame, pane, target);
        if (target.samples() == 1) resources_->draw_pane(frame, pane);
    }
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace normalscope

#include "core/math/projective.h"
#include "gl/driver.h"
#include "gl/rectangles.h"
#include "gl/resources.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <array>

namespace normalscope {

namespace {

bool is_ghost(const SurfaceDraw& draw) { return draw.color.a < 1.0f; }

// What the program of a surface's shaders defines; nothing for the one that is always there. A ghost needs no light, which is most
// of what a surface costs; a picture by itself is not worth another program.
std::string defines(const Frame& frame, const SurfaceDraw& draw, bool first_picture) {
    std::string result;
    const auto add = [&](const char* word) { result += (result.empty() ? "" : "\n#define ") + std::string(word); };
    if (draw.shows == SurfaceColor::Error && frame.error_maps) add("ERROR_MAP");
    if (draw.shows == SurfaceColor::Normals) add("NORMALS");
    if (!is_affine(glm::dmat4(draw.world_from_object))) add("PROJECTIVE");
    if (is_ghost(draw) && !first_picture) add("GHOST");
    return result;
}

}  // namespace

glm::mat4 Resources::seen(const Pane& pane, const glm::dmat4& clip_from_world) const {
    if (!only_sample) return clip_from_world;
    const glm::dvec2 shift = -2.0 * glm::dvec2(*only_sample) / glm::dvec2(pane.rect.size);
    return glm::translate(glm::dmat4(1.0), glm::dvec3(shift, 0.0)) * clip_from_world;
}

void Resources::begin(const SceneProgram& program, const Frame& frame, const Pane& pane) const {
    program.use();
    program.clip_from_world = seen(pane, pane.view.clip_from_world());
    program.eye = pane.view.eye().xyz;
    program.toward_light = frame.toward_light;
    program.ghost = 0.0f;
    program.arrow_length = 0.0f;
    program.outside = 0.0f;
    program.color_coded = 1.0f;
    program.zero_is_black = 0.0f;
    program.tint = glm::vec4(0.0f);
}

void Resources::set_normals(const SceneProgram& program, const NormalMap& normals) {
    program.normal_matrix = normals.matrix;
    program.normal_w = static_cast<float>(normals.w);
    program.unit_at_vertices = static_cast<float>(normals.at_vertices);
    program.unit_at_pixels = normals.at_pixels ? 1.0f : 0.0f;
}

void Resources::set_look(const SceneProgram& program, const Pane& pane, const SurfaceDraw& draw) const {
    if (draw.yields) program.clip_from_world = seen(pane, pane.view.clip_from_world_behind(kYields));
    set_normals(program, draw.normals.value_or(NormalMap{.matrix = glm::dmat4(0.0)}));
    program.zero_is_black = draw.black_where_zero ? 1.0f : 0.0f;
    program.outside = draw.outside;
    program.color_coded = 0.0f;
    program.inside_color = draw.inside_color;
    program.ghost = is_ghost(draw) ? 1.0f : 0.0f;
}

void Resources::set_error_maps(const SurfaceProgram& program, const Frame& frame) {
    const auto& [shown, planes] = *frame.error_maps;
    program.naive_matrix = shown.matrix;
    program.naive_w = static_cast<float>(shown.w);
    program.inverse_transpose_matrix = glm::dmat3(planes);
    program.planes = planes;
    program.ramp = std::span<const glm::vec3>(kErrorRamp);
}

void Resources::draw_surface(const Frame& frame, const Pane& pane, const SurfaceDraw& draw) {
    const bool as_mesh =
        !draws_floats() || (frame.quality == Quality::Sketch && !(tracer && tracer->ready(*frame.surface->implicit)));
    if (draw.traced_object_from_world && !as_mesh) return draw_traced(frame, pane, draw);
    const std::string wanted = defines(frame, draw, first_picture);
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

void Resources::draw_traced(const Frame& frame, const Pane& pane, const SurfaceDraw& draw) {
    const bool fine = frame.quality == Quality::Fine;
    const int coarseness = fine ? 1 : draft_coarseness;
    std::vector<glm::vec2> shifts;
    if (fine && !only_sample) shifts = sample_places();
    for (glm::vec2& place : shifts) place -= 0.5f;
    if (fine && only_sample) shifts = {*only_sample};
    if (!tracer) tracer.emplace();
    std::string wanted = carries_much() ? "TRACED\n#define CARRIES" : "TRACED";
    if (const std::string rest = defines(frame, draw, first_picture); !rest.empty()) wanted += "\n#define " + rest;
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
    const glm::ivec2 program_origin(viewport[0], viewport[1]);
    program.pane_origin = program_origin;
    const PixelRect& box = tracer->box();
    normalscope::scissor(common({{scissor[0], scissor[1]}, {scissor[2], scissor[3]}},
                                {program_origin + coarseness * box.origin, coarseness * box.size}));
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
    program.sample_mask = ~0;
    program.shift = glm::vec2(0.0f);
    program.tile = tracer->tile();
    program.least = Tracer::kEmpty;
    tracer->draw_tiles();

    program.leave_edges = 0.0f;
    program.least = Tracer::kNoEdge;
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        bind(GL_TEXTURE0, tracer->samples(k).id());
        if (!only_sample) {
            mask_samples(1 << k);
            program.sample_mask = 1 << k;
        }
        program.shift = 2.0f * shifts[k] / glm::vec2(pane.rect.size);
        tracer->draw_tiles();
    }
    if (!only_sample) unmask_samples();
    glScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
}

}  // namespace normalscope

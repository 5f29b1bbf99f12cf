#include "gl/renderer.h"

#include "gl/programs.h"
#include "gl/vertex_data.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <optional>

namespace normalscope {

/// What lives on the GPU: programs and vertices, of which the surface's are kept until another surface comes.
struct Renderer::Resources {
    BackdropProgram backdrop_program;
    SceneProgram scene_program;
    std::optional<ErrorMapProgram> error_map_program;  // compiled when first wanted
    PaneVertices backdrop;
    SolidVertices solids;

    std::shared_ptr<const Surface> surface;
    std::optional<MeshVertices> mesh;
    std::optional<ArrowVertices> arrows;

    void hold(const std::shared_ptr<const Surface>& wanted) {
        if (surface == wanted) return;
        mesh.emplace(wanted->mesh);
        arrows.emplace(wanted->arrows);
        surface = wanted;
    }

    void draw_backdrop(const Frame& frame, const Pane& pane);
    void draw_surface(const Frame& frame, const Pane& pane, const SurfaceDraw& draw);
    void draw_arrows(const Frame& frame, const Pane& pane);
    void draw_solids(const Frame& frame, const Pane& pane, const std::vector<SolidVertex>& vertices);

private:
    void begin(const SceneProgram& program, const Frame& frame, const Pane& pane) const;
    static void set_normals(const SceneProgram& program, const NormalMap& normals);
};

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

void Renderer::Resources::draw_backdrop(const Frame& frame, const Pane& pane) {
    const ThemeColors colors = theme_colors(frame.theme);
    glDisable(GL_DEPTH_TEST);
    backdrop_program.use();
    backdrop_program.world_from_clip = glm::mat4(glm::inverse(pane.view.clip_from_world()));
    backdrop_program.eye = pane.view.eye().xyz;
    backdrop_program.top_color = colors.background_top;
    backdrop_program.bottom_color = colors.background_bottom;
    backdrop_program.grid_color = colors.grid;
    backdrop_program.ground = frame.ground_height.value_or(0.0f);
    backdrop_program.grid_amount = frame.ground_height ? 1.0f : 0.0f;
    backdrop_program.shadow = frame.shadow_from_ground;
    backdrop.draw();
    glEnable(GL_DEPTH_TEST);
}

void Renderer::Resources::draw_surface(const Frame& frame, const Pane& pane, const SurfaceDraw& draw) {
    const SceneProgram* program = &scene_program;
    if (draw.by_error && frame.error_maps) {
        if (!error_map_program) error_map_program.emplace();
        program = &*error_map_program;
    }
    begin(*program, frame, pane);
    if (program != &scene_program) {
        const auto& [naive, right] = *frame.error_maps;
        error_map_program->naive_matrix = naive.matrix;
        error_map_program->naive_w = static_cast<float>(naive.w);
        error_map_program->inverse_transpose_matrix = glm::dmat3(right.matrix);
        error_map_program->ramp = std::span<const glm::vec3>(kErrorRamp);
    }
    program->world_from_object = draw.world_from_object;
    set_normals(*program, draw.normals.value_or(NormalMap{.matrix = glm::dmat4(0.0)}));
    program->zero_is_black = draw.black_where_zero ? 1.0f : 0.0f;
    program->outside = draw.outside;
    program->color_coded = 0.0f;
    program->inside_color = draw.inside_color;
    program->tint = draw.color;
    const bool ghost = draw.color.a < 1.0f;
    program->ghost = ghost ? 1.0f : 0.0f;
    if (draw.cull != SurfaceDraw::Cull::None) glEnable(GL_CULL_FACE);
    glCullFace(draw.cull == SurfaceDraw::Cull::Inside && draw.mirrored ? GL_FRONT : GL_BACK);
    mesh->draw();
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
}

void Renderer::Resources::draw_arrows(const Frame& frame, const Pane& pane) {
    if (pane.arrows.empty()) return;
    begin(scene_program, frame, pane);
    glEnable(GL_CULL_FACE);
    for (const ArrowDraw& draw : pane.arrows) {
        scene_program.world_from_object = draw.world_from_object;
        set_normals(scene_program, draw.normals);
        scene_program.tint = glm::vec4(draw.color, 1.0f);
        scene_program.arrow_length = draw.length;
        scene_program.shaft_radius = draw.radius;
        scene_program.head_length =
            std::min(ArrowProportions::kHeadLength * draw.radius, ArrowProportions::kLongestHead * draw.length);
        arrows->draw();
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

void Renderer::draw(const Frame& frame, int framebuffer_height) {
    resources_->hold(frame.surface);
    glEnable(GL_SCISSOR_TEST);
    glDepthFunc(GL_LEQUAL);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const Pane& pane : frame.panes) {
        const int bottom = framebuffer_height - pane.rect.origin.y - pane.rect.size.y;
        glViewport(pane.rect.origin.x, bottom, pane.rect.size.x, pane.rect.size.y);
        glScissor(pane.rect.origin.x, bottom, pane.rect.size.x, pane.rect.size.y);
        glClear(GL_DEPTH_BUFFER_BIT);

        resources_->draw_backdrop(frame, pane);
        for (const SurfaceDraw& draw : pane.surfaces)
            if (draw.color.a >= 1.0f) resources_->draw_surface(frame, pane, draw);
        resources_->draw_solids(frame, pane, pane.solids);
        resources_->draw_arrows(frame, pane);
        glEnable(GL_BLEND);
        glDepthMask(GL_FALSE);
        for (const SurfaceDraw& draw : pane.surfaces)
            if (draw.color.a < 1.0f) resources_->draw_surface(frame, pane, draw);
        resources_->draw_solids(frame, pane, pane.translucent);
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

namespace {

std::string gl_string(GLenum which) {
    const GLubyte* text = glGetString(which);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

std::string renderer_name() { return gl_string(GL_RENDERER); }
std::string gl_version() { return gl_string(GL_VERSION); }

}  // namespace normalscope

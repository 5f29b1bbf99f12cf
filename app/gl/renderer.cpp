#include "gl/renderer.h"

#include "core/picture/drawn_box.h"
#include "core/picture/ground.h"
#include "gl/driver.h"
#include "gl/rectangles.h"
#include "gl/resources.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <string>

namespace normalscope {

namespace {

void set_sky_and_ground(const BackdropProgram& program, const Frame& frame, const Pane& pane) {
    const ThemeColors colors = theme_colors(frame.theme);
    program.world_from_clip = glm::mat4(glm::inverse(pane.view.clip_from_world()));
    program.ray_depth = static_cast<float>(pane.view.ray_depth());
    program.eye = pane.view.eye().xyz;
    program.top_color = frame.plain_ground.value_or(colors.background_top);
    program.bottom_color = frame.plain_ground.value_or(colors.background_bottom);
    program.grid_color = colors.grid;
    program.ground = frame.ground_height.value_or(0.0f);
    program.unit = static_cast<float>(frame.unit);
    program.grid_amount = frame.ground_height ? 1.0f : 0.0f;
    program.grid_fade = static_cast<float>(kGridFade);
    program.shadow = frame.shadow_from_ground;
    program.shadow_fade = static_cast<float>(kShadowFade);
}

}  // namespace

void Resources::draw_backdrop(const Frame& frame, const Pane& pane, const Target& target) {
    const PixelRect rect = upright(pane.rect, target);
    look_at(rect);
    // Where all of a pixel is written, Mesa compiles the shader a second time for tiles that are wholly covered.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    const PixelRect sampled = target.samples() > 1 ? upright(target.sampled(), target) : PixelRect{};
    std::string resolve;
    int samples = 1;
    if (target.samples() > 1) {
        const Samples::Colors colors = target.held().colors();
        resolve = colors.kind == GL_TEXTURE_2D ? "RESOLVE\n#define APART" : "RESOLVE";
        samples = colors.count;
        target.bind_picture();
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(colors.kind, colors.texture);
    }
    const auto draw = [&](const PixelRect& part, const std::string& defines) {
        if (part.size.x <= 0 || part.size.y <= 0) return;
        const BackdropProgram& program = backdrop_programs.try_emplace(defines, defines).first->second;
        scissor(part);
        program.use();
        set_sky_and_ground(program, frame, pane);
        program.samples = samples;
        program.drawn_low = sampled.origin;
        program.drawn_size = sampled.size;
        if (!resolve.empty()) program.drawn_step = target.held().size();
        backdrop.draw();
    };
    // A picture by itself is not worth another program. From the second on, each pixel is given what it needs.
    if (first_picture) {
        draw(rect, resolve);
    } else {
        const PixelRect ground = upright(ground_box(frame, pane), target), with_samples = common(rect, sampled);
        const auto draw_both = [&](const PixelRect& part, const std::string& defines) {
            const PixelRect with_ground = common(part, ground);
            draw(with_ground, defines);
            for (const PixelRect& strip : around(part, with_ground))
                draw(strip, defines.empty() ? "SKY" : defines + "\n#define SKY");
        };
        draw_both(with_samples, resolve + "\n#define SAMPLES " + std::to_string(samples));
        for (const PixelRect& strip : around(rect, with_samples)) draw_both(strip, "");
        scissor(rect);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Resources::draw_arrows(const Frame& frame, const Pane& pane) {
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

void Resources::draw_solids(const Frame& frame, const Pane& pane, const std::vector<SolidVertex>& vertices) {
    begin(scene_program, frame, pane);
    scene_program.world_from_object = glm::mat4(1.0f);
    set_normals(scene_program, {});
    solids.draw(vertices);
}

Renderer::Renderer() : resources_(std::make_unique<Resources>()) {}
Renderer::~Renderer() = default;

void Resources::draw_pane(const Frame& frame, const Pane& pane) {
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

namespace {

bool is_traced(const Pane& pane) {
    return std::ranges::any_of(pane.surfaces,
                               [](const SurfaceDraw& draw) { return draw.traced_object_from_world.has_value(); });
}

// What is traced is drawn to each sample by itself.
Samples::Layout layout_for(const Frame& frame) {
    const bool one_by_one = frame.quality == Quality::Fine && !masks_samples() && draws_floats();
    return one_by_one && std::ranges::any_of(frame.panes, is_traced) ? Samples::Layout::Apart
                                                                     : Samples::Layout::Together;
}

}  // namespace

void Renderer::draw(const Frame& frame, Target& target, Beside beside) {
    resources_->hold(frame.surface);
    if (target.samples() > 1) {
        PixelRect box;
        for (const Pane& pane : frame.panes) box = united(box, drawn_box(*frame.surface, pane));
        const Samples& samples = target.bind_samples(box, layout_for(frame));
        const glm::ivec2 origin = upright(box, target).origin;
        glEnable(GL_SCISSOR_TEST);
        for (int round = 0; round < samples.rounds(); ++round) {
            const PixelRect room{samples.corner(round), samples.size()};
            if (samples.rounds() > 1) resources_->only_sample = usual_places()[static_cast<std::size_t>(round)] - 0.5f;
            for (const Pane& pane : frame.panes) {
                PixelRect rect = upright(pane.rect, target);
                rect.origin += room.origin - origin;
                look_at(rect);
                scissor(common(room, rect));
                resources_->draw_pane(frame, pane);
            }
        }
        resources_->only_sample.reset();
    }
    draw_again(frame, target, beside);
}

void Renderer::draw_again(const Frame& frame, Target& target, Beside beside) {
    target.bind_picture();
    // All at once or not at all: what is cleared within a scissor, Mesa fills pixel by pixel. The backdrop covers the panes.
    glDisable(GL_SCISSOR_TEST);
    if (beside == Beside::Cleared) {
        const glm::vec3 ground = theme_colors(frame.theme).panel;
        glClearColor(ground.r, ground.g, ground.b, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    if (target.samples() == 1) glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    for (const Pane& pane : frame.panes) {
        resources_->draw_backdrop(frame, pane, target);
        if (target.samples() == 1) resources_->draw_pane(frame, pane);
    }
    resources_->first_picture = false;
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace normalscope

#include "capture.h"

#include "core/error.h"
#include "core/frame.h"
#include "core/numbers.h"
#include "core/surface.h"
#include "gl/renderer.h"
#include "gl/target.h"
#include "gui.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>

namespace normalscope {

namespace {

bool has_words(const Frame& frame) {
    bool any = !frame.legend.empty() || frame.error_legend;
    for (const Pane& pane : frame.panes) any = any || !pane.labels.empty();
    return any;
}

std::string unknown_tab(const std::string& tab) {
    std::string line = "--tab " + tab + ": there is no such tab; known:";
    for (const std::string_view known : Interface::tabs()) line += " " + std::string(known);
    return line;
}

// Words and lines keep their share of the picture, whatever its size; the panel must stay legible in a small one.
float scale_of(glm::ivec2 size, bool panel) {
    const float share = std::min(static_cast<float>(size.x) / 1280.0f, static_cast<float>(size.y) / 720.0f);
    return std::clamp(std::round(10.0f * share) / 10.0f, panel ? 1.0f : 0.5f, 8.0f);
}

}  // namespace

Capture capture(const Scene& scene, const CaptureOptions& options) {
    prefer_quick_shader_compilation();
    // A large mesh takes as long to read as a context takes to make and its shaders to compile: do both at once.
    SurfaceCache surfaces;
    auto loading = std::async(std::launch::async, [&] { return surfaces.get(scene); });

    const std::unique_ptr<Context> context = make_offscreen_context(options.context);
    context->make_current();
    const Target target(options.size, options.samples);
    Renderer renderer;

    const float scale = scale_of(options.size, options.panel);
    const std::shared_ptr<const Surface> surface = loading.get();
    std::optional<Gui> gui;
    PixelRect rect{{0, 0}, options.size};
    if (options.panel) {
        gui.emplace();
        gui->interface.prepare(scene.theme, scale);
        if (!gui->interface.show_tab(options.tab)) throw UsageError(unknown_tab(options.tab));
        rect = gui->interface.picture(options.size);
    }
    const Frame frame = make_frame(scene, surface, {.rect = rect, .pixel_scale = scale, .handles = options.panel});

    target.bind();
    renderer.draw(frame, options.size.y);
    target.resolve();
    if (!gui && has_words(frame)) gui.emplace();
    if (gui) {
        Status status;
        const Transform<World, Object> m = world_from_object(scene);
        if (const auto naive = normal_map(scene, m, Rule::Naive); naive && options.panel)
            status.errors = error_statistics(surface->mesh, *naive, m.normal_matrices_by_rule());
        // Dear ImGui knows a window's size only after it has laid it out once.
        for (int round = 0; round < (options.panel ? 3 : 1); ++round)
            gui->layout(options.size, scene.theme, scale, [&] {
                Scene unchanged = scene;
                if (options.panel)
                    gui->interface.draw(unchanged, frame, status);
                else
                    gui->interface.draw_words(frame);
            });
        gui->draw();
    }

    Capture result{target.read(), {}};
    if (options.numbers) result.numbers = numbers_text(scene, frame, {renderer_name(), std::string(context->name())});
    return result;
}

}  // namespace normalscope

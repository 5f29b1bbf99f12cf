#include "commands/studio.h"

#include "core/base/error.h"
#include "core/explain/numbers_json.h"
#include "core/image/matte.h"
#include "core/picture/display_scale.h"
#include "core/picture/frame.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"
#include "gl/renderer.h"
#include "gl/target.h"
#include "platform/offscreen_context.h"
#include "ui/offscreen_gui.h"

#include <config.h>

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

}  // namespace

/// What needs a context, in the order in which it must be made.
struct Studio::Equipment {
    explicit Equipment(ContextChoice choice) : context(make_offscreen_context(choice)) { context->make_current(); }

    Target& target_for(const CaptureOptions& options) {
        if (!target || target->size() != options.size || asked_samples != options.samples) {
            target.reset();
            target.emplace(options.size, options.samples);
            asked_samples = options.samples;
        }
        return *target;
    }

    std::unique_ptr<Context> context;
    std::optional<Target> target;
    int asked_samples = 0;  // the driver may have given fewer
    std::optional<Renderer> renderer;
    std::optional<OffscreenGui> gui;
};

// For many pictures optimised shaders save more time than they take to compile (of 640x360 pixels, from about 25 on);
// the pictures are the same to the last bit.
Studio::Studio(ContextChoice context, std::size_t pictures) : choice_(context) {
    constexpr std::size_t kMany = 25;
    if (pictures < kMany) prefer_quick_shader_compilation();
}
Studio::~Studio() = default;

Capture Studio::capture(const Scene& scene, const CaptureOptions& options) {
    if (options.ground == Ground::Scene) return draw(scene, options, std::nullopt);
    Capture white = draw(scene, options, glm::vec3(1.0f));
    if (options.ground == Ground::White) return white;
    white.image = matte(draw(scene, options, glm::vec3(0.0f)).image, white.image);
    return white;
}

Capture Studio::draw(const Scene& scene, const CaptureOptions& options, const std::optional<glm::vec3>& plain_ground) {
    // A large mesh takes as long to read as a context takes to make and its shaders to compile: do both at once.
    auto loading =
        std::async(equipment_ ? std::launch::deferred : std::launch::async, [&] { return surfaces_.get(scene); });
    if (!equipment_) equipment_ = std::make_unique<Equipment>(choice_);
    Target& target = equipment_->target_for(options);
    if (!equipment_->renderer) equipment_->renderer.emplace();
    std::optional<OffscreenGui>& gui = equipment_->gui;

    const float scale = options.lesson ? DisplayScale{}.of(1.0f, options.size, true)
                                       : options.scale.value_or(usual_scale(options.size, options.panel));
    const bool interface = options.panel || options.lesson;
    const std::shared_ptr<const Surface> surface = loading.get();
    PixelRect rect{{0, 0}, options.size};
    // The interface remembers what it showed last, which must not change this picture; words alone are forgotten.
    struct Forget {
        std::optional<OffscreenGui>& gui;
        bool interface;
        ~Forget() {
            if (interface) gui.reset();
        }
    } const forget{gui, interface};
    if (interface) {
        gui.reset();
        gui.emplace();
        if (options.lesson) gui->interface.record_lesson(options.lesson, scene, options.step);
        gui->interface.prepare(scene.theme, scale);
        if (!options.lesson && !gui->interface.show_tab(options.tab)) throw UsageError(unknown_tab(options.tab));
        rect = gui->interface.picture(options.size);
    }
    Frame frame = make_frame(scene, surface, {.rect = rect, .pixel_scale = scale, .handles = options.panel});
    if (plain_ground) {
        frame.plain_ground = plain_ground;
        frame.ground_height.reset();
    }

    // Words are laid out on a thread of their own: that takes as long as to compile a shader.
    const auto lay_out = [&] {
        if (!gui) gui.emplace();
        Status status;
        const Transform<World, Object> m = world_from_object(scene);
        if (const auto naive = normal_map(scene, m, Rule::Naive); naive && interface)
            status.errors = error_statistics(surface->mesh, *naive, m.normal_matrices_by_rule());
        // Dear ImGui knows a window's size only after it has laid it out once.
        for (int round = 0; round < (interface ? 3 : 1); ++round)
            gui->layout(options.size, scene.theme, scale, [&] {
                Scene unchanged = scene;
                if (interface)
                    gui->interface.draw(unchanged, frame, status);
                else
                    gui->interface.draw_words(frame);
            });
    };
    std::future<void> words;
    if (interface || has_words(frame)) words = std::async(std::launch::async, lay_out);

    equipment_->renderer->draw(frame, target);
    Capture result{.image = target.read()};
    if (surface->implicit) result.note = surface->mesh.note;
    if (words.valid()) {
        words.get();
        gui->paint(result.image);
    }
    if (options.numbers)
        result.numbers = numbers_text(scene, frame,
                                      {.program = NORMALSCOPE_VERSION,
                                       .renderer = renderer_name(),
                                       .gl_version = gl_version(),
                                       .context = std::string(equipment_->context->name())});
    return result;
}

}  // namespace normalscope

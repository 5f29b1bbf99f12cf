#include "commands/studio.h"

#include "core/base/beside.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/explain/numbers_json.h"
#include "core/frame/display_scale.h"
#include "core/frame/frame.h"
#include "core/image/matte.h"
#include "core/lessons/tabs.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"
#include "gl/renderer.h"
#include "gl/target.h"
#include "gl/version.h"
#include "platform/driver_variables.h"
#include "platform/offscreen_context.h"
#include "platform/system_fonts.h"
#include "ui/offscreen_gui.h"

#include <config.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

namespace normalscope {

namespace {

bool has_words(const Frame& frame) {
    bool any = !frame.legend.empty() || frame.color_key;
    for (const Pane& pane : frame.panes) any = any || !pane.labels.empty();
    return any;
}

std::string unknown_tab(const std::string& tab) {
    if (tab.starts_with("derivation#")) return "--tab " + tab + ": its lines are derivation#1 to derivation#12";
    return "--tab " + tab + ": there is no such tab; known: " + joined(tab_names(), " ");
}

std::uint32_t pixel_of(const Image& image, int x, int y) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, image.pixel(x, y), sizeof pixel);
    return pixel;
}

// From this column on, and down to the last row that holds anything but ground.
Image what_is_full(const Image& image, int left) {
    const std::uint32_t ground = pixel_of(image, left, image.size.y - 1);
    const auto is_ground = [&](int y) {
        for (int x = left; x < image.size.x; ++x)
            if (pixel_of(image, x, y) != ground) return false;
        return true;
    };
    int height = image.size.y;
    while (height > 1 && is_ground(height - 1)) --height;
    return cropped(image, {left, 0}, {image.size.x - left, std::min(height + 16, image.size.y)});
}

}  // namespace

/// What needs a context, in the order in which it must be made.
struct Studio::Equipment {
    explicit Equipment(const ContextOptions& options) : context(make_offscreen_context(options)) {
        context->make_current();
    }

    Target& target_for(const CaptureOptions& options) {
        if (!target || target->size() != options.size || asked_samples != options.samples) {
            target.reset();
            target.emplace(options.size, options.samples);
            asked_samples = options.samples;
        }
        return *target;
    }

    /// Anew, as it is when nothing has happened yet; gives the room that it leaves to the picture.
    PixelRect open_interface(const Scene& scene, const CaptureOptions& options, float scale) {
        gui.reset();
        new_gui();
        if (options.lesson) gui->interface.record_lesson(options.lesson, scene, options.step, options.answer);
        gui->interface.prepare(scene.theme, scale);
        Interface& interface = gui->interface;
        if (!options.lesson && !(options.panel ? interface.show_tab(options.tab) : interface.record_tab(options.tab)))
            throw UsageError(unknown_tab(options.tab));
        return gui->interface.picture(options.size);
    }

    void new_gui() {
        gui.emplace();
        gui->interface.find_fonts_by(system_fonts);
    }

    void lay_out_interface(const Scene& scene, const Frame& frame, glm::ivec2 size, float scale) {
        Status status;
        const Transform<World, Object> m = world_from_object(scene);
        if (const auto naive = normal_map(scene, m, Rule::Naive))
            status.errors = error_statistics(frame.surface->mesh, *naive, m);
        // Dear ImGui knows a window's size only after it has laid it out once.
        for (int round = 0; round < 3; ++round)
            gui->layout(size, scene.theme, scale, [&] {
                Scene unchanged = scene;
                gui->interface.draw(unchanged, frame, status);
            });
    }

    void lay_out_words(const Scene& scene, const Frame& frame, glm::ivec2 size, float scale) {
        if (!gui) new_gui();
        gui->layout(size, scene.theme, scale, [&] { gui->interface.draw_words(frame); });
    }

    std::unique_ptr<Context> context;
    std::optional<Target> target;
    int asked_samples = 0;  // the driver may have given fewer
    std::optional<Renderer> renderer;
    std::optional<OffscreenGui> gui;
};

// For many pictures optimised shaders save more time than they take to compile (of 640x360 pixels, from about 25 on);
// the pictures are the same to the last bit. And where each process draws with as many threads as there are processors,
// they are only in each other's way.
Studio::Studio(const StudioOptions& options)
    : context_{.choice = options.context, .quick_shaders = options.pictures < 25} {
    if (options.jobs > 1) context_.threads = std::max<std::size_t>(1, processors() / options.jobs);

    const std::string crashing = crashing_driver_variables([&] { capture(Scene{}, {.size = {16, 16}}); });
    if (!crashing.empty())
        throw ContextError(crashing +
                           ": with that the graphics driver crashes; unset it, or set GALLIUM_DRIVER=llvmpipe "
                           "and LP_NATIVE_VECTOR_WIDTH=128");
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
    const bool first = !equipment_;
    if (first) equipment_ = std::make_unique<Equipment>(context_);
    // A large mesh takes as long to read as shaders take to compile: do both at once.
    auto loading = beside([&] { return surfaces_.get(scene); }, first ? Begin::AtOnce : Begin::WhenAsked);
    Target& target = equipment_->target_for(options);
    if (!equipment_->renderer) equipment_->renderer.emplace();

    const float scale = options.lesson ? DisplayScale{}.of(1.0f, options.size, true)
                                       : options.scale.value_or(options.panel ? usual_panel_scale(options.size)
                                                                              : usual_scale(options.size));
    const bool interface = options.panel || options.lesson || !options.tab.empty();
    const std::shared_ptr<const Surface> surface = loading.get();
    // The interface remembers what it showed last, which must not change this picture; words alone are forgotten.
    struct Forget {
        std::optional<OffscreenGui>& gui;
        bool interface;
        ~Forget() {
            if (interface) gui.reset();
        }
    } const forget{equipment_->gui, interface};
    const PixelRect rect =
        interface ? equipment_->open_interface(scene, options, scale) : PixelRect{{0, 0}, options.size};
    StepMarks marks = options.lesson ? equipment_->gui->interface.marks() : options.marks;
    if (interface && !options.lesson)
        if (const auto line = equipment_->gui->interface.marks().line) marks.line = line;
    Frame frame =
        make_frame(scene, surface, {.rect = rect, .pixel_scale = scale, .handles = options.panel, .marks = marks});
    if (plain_ground) {
        frame.plain_ground = plain_ground;
        frame.ground_height.reset();
    }

    // Words are laid out on a thread of their own: that takes as long as to compile a shader.
    Beside<void> words;
    if (interface || has_words(frame))
        words = beside([&] {
            if (interface)
                equipment_->lay_out_interface(scene, frame, options.size, scale);
            else
                equipment_->lay_out_words(scene, frame, options.size, scale);
        });

    equipment_->renderer->draw(frame, target);
    Capture result{.image = target.read()};
    result.notes = frame.notes;
    if (words) {
        words.get();
        equipment_->gui->paint(result.image);
        if (options.tab_alone) result.image = what_is_full(result.image, rect.origin.x + rect.size.x + 2);
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

#include "commands/studio.h"

#include "commands/tab_image.h"
#include "core/base/beside.h"
#include "core/base/error.h"
#include "core/base/system.h"
#include "core/base/text.h"
#include "core/explain/numbers_json.h"
#include "core/frame/display_scale.h"
#include "core/frame/frame.h"
#include "core/image/matte.h"
#include "core/image/shrunk.h"
#include "core/lessons/tabs.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"
#include "gl/renderer.h"
#include "gl/target.h"
#include "gl/version.h"
#include "platform/driver_variables.h"
#include "platform/offscreen_context.h"
#include "platform/system_fonts.h"
#include "ui/kit/side_panel.h"
#include "ui/offscreen_gui.h"

#include <config.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace normalscope {

namespace {

bool has_words(const Frame& frame) {
    bool any = !frame.legend.empty() || frame.color_key;
    for (const Pane& pane : frame.panes) any = any || !pane.labels.empty();
    return any;
}

float scale_for(const CaptureOptions& options) {
    if (options.scale) return *options.scale;
    if (options.lesson) return DisplayScale{}.of(1.0f, options.size, true);
    return options.panel ? usual_panel_scale(options.size) : usual_scale(options.size);
}

std::string unknown_tab(const std::string& tab) {
    const std::string line(without_numbers(tab));
    if (line.starts_with(kLineInTab) && line.find_first_not_of("0123456789", kLineInTab.size()) == line.npos)
        return "--tab " + tab + ": there is no such line; the derivation has lines 1 to " +
               std::to_string(kDerivationPassages);
    return "--tab " + tab + ": there is no such tab; " +
           (tab.starts_with(kTabs[0].name) ? tabs_of_the_derivation() + "; " : "") +
           "known: " + joined(tab_names(), " ");
}

// On a terminal it is said what takes so long; where there are many pictures, a bar tells of them.
std::shared_ptr<const Surface> waited_for(Beside<std::shared_ptr<const Surface>>& loading, bool alone) {
    if (!alone || !is_terminal(stderr) || loading.ready(std::chrono::seconds(1))) return loading.get();
    struct Line {
        Line() { say("computing the surface \u2026  Ctrl+C cancels"); }
        ~Line() { say("\r\x1b[K"); }
        static void say(const char* text) {
            std::fputs(text, stderr);
            std::fflush(stderr);
        }
    } const line;
    return loading.get();
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
        if (options.lesson && options.tab_is == CaptureOptions::TabIs::Apart) interface.show_tab("");
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

// For many pictures, or as many arrows as can be in one, optimised shaders save more time than they take to compile; the
// pictures are the same to the last bit. And where each process draws with as many threads as there are processors, they
// are only in each other's way.
constexpr std::size_t kManyPictures = 25;  // of 640x360 pixels
constexpr int kArrowsWorthIt = 300'000;

Studio::Studio(const StudioOptions& options)
    : context_{.choice = options.context, .quick_shaders = options.pictures < kManyPictures},
      alone_(options.pictures == 1) {
    if (options.jobs > 1) context_.threads = std::max<std::size_t>(1, processors() / options.jobs);

    const std::string crashing = crashing_driver_variables([&] { capture(Scene{}, {.size = {16, 16}}); });
    if (!crashing.empty())
        throw ContextError(crashing +
                           ": with that the graphics driver crashes; unset it, or set GALLIUM_DRIVER=llvmpipe "
                           "and LP_NATIVE_VECTOR_WIDTH=128");
}
Studio::~Studio() = default;

Studio::Equipment& Studio::equipment(const Scene& first) {
    if (equipment_) return *equipment_;
    const bool no_arrows = first.arrows.show && first.arrows.show->empty();
    if (first.arrows.limit >= kArrowsWorthIt && !no_arrows) context_.quick_shaders = false;
    equipment_ = std::make_unique<Equipment>(context_);
    return *equipment_;
}

/// A tab by itself, and the line of the derivation that it stands at.
struct Studio::TabPicture {
    Image image;
    std::optional<DerivationAt> line;
};

Studio::TabPicture Studio::draw_tab(const Scene& scene, const CaptureOptions& options, float scale) {
    constexpr float kBeside = 160.0f;    // a picture that a tab stands beside
    constexpr float kTallest = 4000.0f;  // more than any of them
    constexpr float kSmallest = 0.25f;   // that an interface has
    scale = std::max(scale, kSmallest);
    Equipment& equipment = this->equipment(scene);
    CaptureOptions tab = options;
    tab.size = glm::ivec2(scale * glm::vec2(kBeside + kSideWidth, kTallest));
    const PixelRect rect = equipment.open_interface(scene, tab, scale);
    const Frame frame = make_frame(scene, surfaces_.get(scene),
                                   {.rect = rect, .pixel_scale = scale, .marks = equipment.gui->interface.marks()});
    equipment.lay_out_interface(scene, frame, tab.size, scale);
    Image image = filled(tab.size, theme_colors(scene.theme).panel);
    equipment.gui->paint(image);
    TabPicture result{what_is_full(image, rect.origin.x + rect.size.x + 2), equipment.gui->interface.marks().line};
    equipment.gui.reset();
    return result;
}

namespace {

// How much smaller it must be to stand beside a picture of which enough is left.
float smaller_for(glm::ivec2 tab, glm::ivec2 all) {
    constexpr float kMostOfWidth = 0.62f;
    return std::min({1.0f, static_cast<float>(all.y) / static_cast<float>(tab.y),
                     kMostOfWidth * static_cast<float>(all.x) / static_cast<float>(tab.x)});
}

struct TabFit {
    int columns = 1;
    float smaller = 1.0f;
};
// In as many columns as leave its letters largest.
TabFit fit_of(const Image& tab, glm::ivec2 all) {
    TabFit best{1, smaller_for(tab.size, all)};
    for (int columns = 2; columns <= 3; ++columns)
        if (const float smaller = smaller_for(in_columns(tab, columns).size, all); smaller > best.smaller)
            best = {columns, smaller};
    return best;
}

}  // namespace

Capture Studio::draw_with_tab(const Scene& scene, CaptureOptions options) {
    const float scale = scale_for(options);
    const CaptureOptions alone{.tab = options.lesson ? options.lesson->steps[options.step].tab : options.tab};
    TabPicture tab = draw_tab(scene, alone, scale);
    const TabFit fit = fit_of(tab.image, options.size);
    float smaller = fit.smaller;
    for (int i = 0; i < 3 && smaller < 1.0f; ++i) {  // words are as wide as whole pixels have them
        tab = draw_tab(scene, alone, scale * smaller);
        const Image columns = in_columns(tab.image, fit.columns);
        if (smaller_for(columns.size, options.size) == 1.0f) break;
        smaller *= 0.99f * smaller_for(columns.size, options.size);
    }
    tab.image = in_columns(tab.image, fit.columns);
    if (const float still = smaller_for(tab.image.size, options.size); still < 1.0f)
        tab.image = shrunk_by(tab.image, static_cast<int>(std::ceil(1.0f / still)));
    options.size.x -= tab.image.size.x;
    options.scale = scale;
    options.tab.clear();
    options.tab_is = CaptureOptions::TabIs::Apart;
    options.marks.line = tab.line ? tab.line : options.marks.line;
    Capture result = draw(scene, options, std::nullopt);
    result.image = with_at_right(result.image, tab.image, theme_colors(scene.theme).panel);
    return result;
}

Capture Studio::capture(const Scene& scene, const CaptureOptions& options) {
    using enum CaptureOptions::TabIs;
    if (options.tab_is == Alone) return {draw_tab(scene, options, scale_for(options)).image};
    if (options.lesson ? !options.lesson->steps[options.step].tab.empty()
                       : options.tab_is == Whole && !options.tab.empty())
        return draw_with_tab(scene, options);
    if (options.ground == Ground::Scene) return draw(scene, options, std::nullopt);
    Capture white = draw(scene, options, glm::vec3(1.0f));
    if (options.ground == Ground::White) return white;
    white.image = matte(draw(scene, options, glm::vec3(0.0f)).image, white.image);
    return white;
}

Capture Studio::draw(const Scene& scene, const CaptureOptions& options, const std::optional<glm::vec3>& plain_ground) {
    const bool first = !equipment_;
    (void)equipment(scene);
    // A large mesh takes as long to read as shaders take to compile: do both at once.
    auto loading = beside([&] { return surfaces_.get(scene); }, first ? Begin::AtOnce : Begin::WhenAsked);
    Target& target = equipment_->target_for(options);
    if (!equipment_->renderer) equipment_->renderer.emplace();

    const float scale = scale_for(options);
    const bool interface = options.panel || options.lesson || !options.tab.empty();
    const std::shared_ptr<const Surface> surface = waited_for(loading, alone_);
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
    if (options.marks.line) marks.line = options.marks.line;
    if (interface && !options.lesson)
        if (const auto line = equipment_->gui->interface.marks().line) marks.line = line;
    Frame frame =
        make_frame(scene, surface, {.rect = rect, .pixel_scale = scale, .handles = options.panel, .marks = marks});
    frame.legend_corner = options.legend_corner;
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

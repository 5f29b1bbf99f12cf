#pragma once

#include "core/base/context_choice.h"
#include "core/frame/frame.h"
#include "core/frame/step_marks.h"
#include "core/image/ground.h"
#include "core/image/image.h"
#include "core/lessons/lesson.h"
#include "core/scene/scene.h"
#include "core/surface/surface.h"
#include "platform/offscreen_context.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

struct CaptureOptions {
    glm::ivec2 size{1280, 720};
    int samples = 4;
    Ground ground = Ground::Scene;
    std::optional<float> scale;  ///< of words and lines; usual_scale where it is not given
    bool panel = false;          ///< the interface too
    std::string tab;             ///< the tab beside the picture; empty: none
    /// Cut off where the picture ends; all of it, in letters as small as that takes; it alone, as high as it is; or the
    /// picture without it.
    enum class TabIs { Cut, Whole, Alone, Apart } tab_is = TabIs::Cut;
    bool numbers = false;  ///< fill Capture::numbers
    /// With a lesson: what its step says, below the picture, as in presenter mode, and all of its tab.
    std::shared_ptr<const Lesson> lesson{};
    std::size_t step = 0;
    std::optional<std::size_t> answer{};  ///< the choice that has been made of its question
    Frame::LegendCorner legend_corner = Frame::LegendCorner::LowerLeft;
    StepMarks marks{};  ///< where there is no interface, which knows its lesson's own
};

struct Capture {
    Image image;
    std::string numbers{};             ///< JSON text (docs/commands.md)
    std::vector<std::string> notes{};  ///< on the surface: what is not as one may expect
};

/// What a Studio draws with, and how much it is likely to draw.
struct StudioOptions {
    ContextChoice context = ContextChoice::Auto;
    std::size_t pictures = 1;
    std::size_t jobs = 1;  ///< processes that draw at once, this one counted
};

/// Makes pictures of scenes without a window, one after the other: the context, its shaders and the last surface are
/// kept, and a picture does not depend on those before it. Each belongs to the thread that made its first picture.
class Studio {
public:
    /// Throws ContextError where the environment tells the driver something that it crashes on.
    explicit Studio(const StudioOptions& options);
    ~Studio();
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    /// Throws InputError, ContextError, and UsageError for an unknown tab.
    Capture capture(const Scene& scene, const CaptureOptions& options);

private:
    struct Equipment;
    Capture draw(const Scene& scene, const CaptureOptions& options, const std::optional<glm::vec3>& plain_ground);
    Capture draw_with_tab(const Scene& scene, CaptureOptions options);
    struct TabPicture;
    TabPicture draw_tab(const Scene& scene, const CaptureOptions& options, float scale);
    /// Made for the first scene.
    Equipment& equipment(const Scene& first);

    ContextOptions context_;
    bool alone_;  ///< there is one picture
    std::unique_ptr<Equipment> equipment_;
    SurfaceCache surfaces_;
};

}  // namespace normalscope

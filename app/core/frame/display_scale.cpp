#include "core/frame/display_scale.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr double kStep = 1.1, kSmallest = 0.6, kLargest = 3.0;
constexpr double kSmallestWords = 15.0, kPresented = 36.0;

}  // namespace

void DisplayScale::change(bool presenting, int steps) {
    double& factor = presenting ? presenter : interface;
    factor = steps == 0 ? 1.0 : std::clamp(factor * std::pow(kStep, steps), kSmallest, kLargest);
    if (std::abs(factor - 1.0) < 1e-6) factor = 1.0;
}

float DisplayScale::of(float desktop, glm::ivec2 framebuffer, bool presenting) const {
    const double share = std::min(framebuffer.x / 1920.0, framebuffer.y / 1080.0);
    // Not every desktop says how fine its pixels are. In quarters, so that a window being resized rarely changes its fonts.
    if (!presenting) return static_cast<float>(std::max<double>(desktop, std::floor(4.0 * share) / 4.0) * interface);
    return static_cast<float>(std::max(kPresented / kSmallestWords * share, 0.6) * presenter);
}

float usual_scale(glm::ivec2 size) {
    const float share = std::min(static_cast<float>(size.x) / 1280.0f, static_cast<float>(size.y) / 720.0f);
    return std::clamp(std::round(10.0f * share) / 10.0f, 0.5f, 8.0f);
}

float usual_panel_scale(glm::ivec2 size) { return std::max(usual_scale(size), 1.0f); }

}  // namespace normalscope

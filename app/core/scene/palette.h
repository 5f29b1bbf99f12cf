#pragma once

#include "core/scene/scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace normalscope {

/// sRGB in 0 … 1 from 0xRRGGBB.
constexpr glm::vec3 rgb(unsigned hex) {
    return {static_cast<float>(hex >> 16 & 0xFFu) / 255.0f, static_cast<float>(hex >> 8 & 0xFFu) / 255.0f,
            static_cast<float>(hex & 0xFFu) / 255.0f};
}

// One colour, one meaning, everywhere: arrows, equations, plots, legend. Okabe and Ito's palette, which stays apart for
// colour-blind viewers.
inline constexpr glm::vec3 kNaiveColor = rgb(0xD55E00);
inline constexpr glm::vec3 kInverseTransposeColor = rgb(0x009E73);
inline constexpr glm::vec3 kCofactorColor = rgb(0xCC79A7);
inline constexpr glm::vec3 kTangentColor = rgb(0x0072B2);
inline constexpr std::array kAxisColors{rgb(0xD03A3A), rgb(0x3C9A3C),
                                        rgb(0x3A62D0)};  ///< x, y, z: on the axis handles only

/// From no error to 90°: light to dark throughout, so that it reads in grey as well.
inline constexpr std::array kErrorRamp{rgb(0xF3F0EA), rgb(0xF6D58E), rgb(0xE8863A),
                                       rgb(0xB23A2A), rgb(0x6A1034), rgb(0x2B0A2E)};

/// What a theme decides.
struct ThemeColors {
    glm::vec3 background_top, background_bottom;
    glm::vec3 grid;
    glm::vec3 surface;
    glm::vec3 inside;  ///< the back of an open surface
    glm::vec3 ghost;   ///< object-space things
    glm::vec3 text, text_shadow;
    glm::vec3 panel;  ///< what stands beside the picture
};
constexpr ThemeColors theme_colors(Theme theme) {
    if (theme == Theme::DarkContrast)
        return {.background_top = rgb(0x000000),
                .background_bottom = rgb(0x000000),
                .grid = rgb(0x5A5F66),
                .surface = rgb(0xC9CCD0),
                .inside = rgb(0x968D80),
                .ghost = rgb(0xC2C6CC),
                .text = rgb(0xFFFFFF),
                .text_shadow = rgb(0x000000),
                .panel = rgb(0x000000)};
    if (theme == Theme::LightContrast)
        return {.background_top = rgb(0xFFFFFF),
                .background_bottom = rgb(0xFFFFFF),
                .grid = rgb(0xB4B8BC),
                .surface = rgb(0xCFCEC9),
                .inside = rgb(0xA89A83),
                .ghost = rgb(0x55595E),
                .text = rgb(0x000000),
                .text_shadow = rgb(0xFFFFFF),
                .panel = rgb(0xFFFFFF)};
    if (theme == Theme::Dark)
        return {.background_top = rgb(0x2A2D33),
                .background_bottom = rgb(0x16181C),
                .grid = rgb(0x6A7078),
                .surface = rgb(0xBFC3C9),
                .inside = rgb(0x8C8478),
                .ghost = rgb(0xA3A8B0),
                .text = rgb(0xECEEF1),
                .text_shadow = rgb(0x111316),
                .panel = rgb(0x1F2227)};
    return {.background_top = rgb(0xFBFBFA),
            .background_bottom = rgb(0xE6E7E8),
            .grid = rgb(0x9AA0A6),
            .surface = rgb(0xD9D8D4),
            .inside = rgb(0xB3A58F),
            .ghost = rgb(0x80868C),
            .text = rgb(0x22262B),
            .text_shadow = rgb(0xFFFFFF),
            .panel = rgb(0xFFFFFF)};
}

constexpr glm::vec3 arrow_color(ArrowKind kind, Theme theme) {
    switch (kind) {
        case ArrowKind::Naive: return kNaiveColor;
        case ArrowKind::InverseTranspose: return kInverseTransposeColor;
        case ArrowKind::Cofactor: return kCofactorColor;
        case ArrowKind::Object: break;
    }
    return theme_colors(theme).ghost;
}
constexpr glm::vec3 rule_color(Rule rule) { return arrow_color(arrow_kind(rule), Theme::Light); }

/// What stands back, so that something else stands out.
inline glm::vec3 muted(const glm::vec3& color, Theme theme) {
    return 0.3f * color + 0.7f * theme_colors(theme).background_bottom;
}

}  // namespace normalscope

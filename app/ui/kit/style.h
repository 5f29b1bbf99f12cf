#pragma once

#include "core/math/normal_rules.h"
#include "core/scene/scene.h"
#include "ui/kit/fonts.h"

#include <imgui.h>

#include <glm/vec3.hpp>

namespace normalscope {

/// What everything in the interface is drawn with: fonts, colours and the scale.
struct Look {
    Theme theme = Theme::Light;
    float scale = 1.0f;   ///< physical pixels per logical one
    float shrink = 1.0f;  ///< of mathematics, where it stands smaller than the fonts have it
    Fonts fonts;
    bool tips = true;    ///< not after a key: then the pointer only rests where it is
    bool still = false;  ///< a picture of it is made: there is nothing to press

    ImVec4 text, dim;           ///< what is said, and what is said beside it
    ImVec4 panel, card, field;  ///< from back to front
    ImVec4 line;                ///< borders, rules
    ImVec4 accent, on_accent;   ///< what is chosen; neutral, as every hue has its meaning already
    ImVec4 good, bad;           ///< perpendicular, or not

    /// Logical pixels to physical ones, whole so that edges are sharp.
    float px(float logical) const;
    /// The same for what stands smaller than all else, in the fonts that there are.
    Look smaller(float by) const;
    /// A palette colour as text: moved toward the theme's text colour until it reads well on a card.
    ImVec4 readable(const glm::vec3& color) const;
    ImVec4 readable(Rule rule) const;
};

ImVec4 to_imgui(const glm::vec3& color, float alpha = 1.0f);
ImVec4 faded(ImVec4 color, float alpha);
/// A colour for draw lists.
ImU32 packed(const ImVec4& color);

/// The colours of a theme, and Dear ImGui's style to match. Leaves the fonts alone.
void set_style(Look& look, Theme theme, float scale);

}  // namespace normalscope

#include "ui/kit/number_bar.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panel.h"
#include "ui/typeset/small_matrix.h"

#include "core/scene/palette.h"
#include "core/surface/singular_point.h"

#include <algorithm>
#include <array>
#include <string>

namespace normalscope {

// A formula's f away from its surface: only where there is a formula.
void slice_section(Scene& scene, const PanelContext& context) {
    const FormulaSurface* formula = std::get_if<FormulaSurface>(&scene.surface);
    if (!formula) return;
    const Look& look = context.look;
    const bool open = section(look, "Level sets");
    if (!open) return;
    bool on = scene.slice.has_value();
    if (ImGui::Checkbox("slice plane", &on)) {
        if (on)
            scene.slice = Slice{};
        else
            scene.slice.reset();
    }
    tip(look, "A plane on which f is coloured by its level sets f = c: warm inside, where f < 0, cool outside.");
    if (!scene.slice) return;
    Slice& slice = *scene.slice;
    ImGui::SameLine(0, look.px(18));
    ImGui::Checkbox("gradient", &slice.gradient);
    tip(look,
        "∇f as arrows on a grid of the plane, sent to the world by the chosen rule: longer where f is steeper, and "
        "always at right angles to the level sets.");
    static constexpr std::array<Segment, 3> kAxes{
        {{"across x", "The plane x = c."}, {"across y", "The plane y = c."}, {"across z", "The plane z = c."}}};
    int axis = static_cast<int>(slice.axis);
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::SetNextItemWidth(width);
    if (segmented(look, "axis", axis, kAxes)) slice.axis = static_cast<Axis>(axis);
    static constexpr std::array<const char*, 3> kLetters{"x =", "y =", "z ="};
    ImGui::SetNextItemWidth(width);
    number_bar(look, "##at", slice.at,
               {.letter = kLetters.at(static_cast<std::size_t>(axis)),
                .low = -formula->bound,
                .high = formula->bound,
                .range = kCoordinate,
                .about = "Where the plane cuts the object's axis; its knob in the picture can be dragged, too.",
                .rest = 0.0,
                .catches = true});
}

// Beside the probe, where it stands on a point without a normal.
void singular_section(Scene& scene, const PanelContext& context) {
    const auto& singular = context.frame.singular;
    if (!singular) return;
    const Look& look = context.look;
    if (!section(look, "No normal here")) return;
    remark(look, look.bad,
           std::string(singular->undefined ? "∇f does not exist" : "∇f = 0") +
               (singular->fan.empty()
                    ? " at the probe, and no sheet of the surface comes near: there is no neighbour to borrow from."
                    : " at the probe: no single direction is the normal.") +
               (context.frame.fan ? " The fan shows the normals all around." : ""));
    if (singular->fan.empty()) return;
    bool on = scene.borrow.has_value();
    if (ImGui::Checkbox("borrow a neighbour's normal", &on)) {
        if (on)
            scene.borrow = Direction<Object>{};
        else
            scene.borrow.reset();
    }
    tip(look,
        "Ray tracers' cheap remedy: a nearby point's gradient. Which one you get is up to chance, and so is the "
        "light.");
    wrapped(look, look.dim,
            "Any two neighbours can differ by up to " + in_degrees(singular->spread_degrees, 1) +
                ": that much depends on the choice.");
    if (!scene.borrow) return;
    direction_bars(look, "borrow", scene.borrow->azimuth, scene.borrow->elevation,
                   {"around", "Which way the neighbour lies, in object space.", 0.0},
                   {"above", "How far above the horizon the neighbour lies, in object space.", 0.0});
    if (!singular->lender) return;
    const auto line = [&](const char* what, const glm::dvec3& v) {
        dim_text(look, what);
        for (glm::length_t i = 0; i < 3; ++i) {
            ImGui::SameLine();
            text_right(fixed(v[i]), look.px(16 + 88) + look.px(80) * static_cast<float>(i + 1));
        }
    };
    line("borrowed from", singular->lender->point.xyz);
    line("its n object", singular->lender->normal.xyz);
}

}  // namespace normalscope

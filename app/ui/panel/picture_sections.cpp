#include "ui/panel/panel.h"

#include "core/scene/palette.h"
#include "ui/kit/number_bar.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace normalscope {

namespace {

// The kinds that are seen now, in any of the panes.
std::vector<ArrowKind> seen_arrows(const Scene& scene, const Frame& frame) {
    if (scene.arrows.show) return *scene.arrows.show;
    std::vector<ArrowKind> seen;
    for (const Pane& pane : frame.panes)
        for (const ArrowKind kind : shown_arrows(scene, scene.view == ViewMode::Split ? pane.rule : scene.rule))
            if (std::ranges::count(seen, kind) == 0) seen.push_back(kind);
    return seen;
}

void push_small_boxes(const Look& look) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(4), look.px(1)));
}

void arrow_kinds(const Look& look, Scene& scene, const Frame& frame) {
    static constexpr std::array<const char*, 4> kLabels{"object's n", "M n", "(M⁻¹)ᵀ n", "cof(M) n"};
    static constexpr std::array<const char*, 4> kAbout{
        "The untransformed normals, on the ghost of the untransformed object.", "The naive rule's arrows.",
        "The inverse transpose's arrows.", "The cofactor matrix's arrows."};
    const std::vector<ArrowKind> seen = seen_arrows(scene, frame);
    const float half = ImGui::GetContentRegionAvail().x / 2, left = ImGui::GetCursorPosX();
    push_small_boxes(look);
    for (std::size_t i = 0; i < kArrowKinds.size(); ++i) {
        if (i % 2 == 1) ImGui::SameLine(left + half);
        const ArrowKind kind = kArrowKinds[i];
        bool on = std::ranges::count(seen, kind) > 0;
        ImGui::PushID(static_cast<int>(i));
        const bool changed = ImGui::Checkbox("##kind", &on);
        tip(look, kAbout[i]);
        ImGui::PopID();
        ImGui::SameLine();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float y = at.y + ImGui::GetFrameHeight() / 2;
        const glm::vec3 color = arrow_color(kind, look.theme);
        draw_arrow(*ImGui::GetWindowDrawList(), arrow_look(kind), {at.x, y}, {at.x + look.px(26), y}, look.px(3),
                   packed(to_imgui(color)));
        ImGui::SetCursorScreenPos({at.x + look.px(33), at.y});
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(kLabels[i]);
        if (!changed) continue;
        std::vector<ArrowKind> wanted;
        for (const ArrowKind k : kArrowKinds)
            if (k == kind ? on : std::ranges::count(seen, k) > 0) wanted.push_back(k);
        scene.arrows.show = wanted;
    }
    ImGui::PopStyleVar();
}

struct Toggle {
    const char *label, *about;
    bool Shown::* value;
};

}  // namespace

void arrows_section(Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    const bool open = section(look, "Arrows");
    ImGui::PushFont(look.fonts.small);
    if (scene.arrows.show) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize("auto").x - look.px(16));
        if (ImGui::SmallButton("auto")) scene.arrows.show.reset();
        tip(look, "Back to the arrows that the view and the rule call for.");
    } else {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize("as the view calls for").x);
        dim_text(look, "as the view calls for");
    }
    ImGui::PopFont();
    if (!open) return;

    arrow_kinds(look, scene, context.frame);
    static constexpr std::array<Segment, 2> kPlaces{
        {{"at vertices", "An arrow at each vertex; the surface is shaded smoothly."},
         {"at faces", "An arrow at each face's middle; the faces are shaded flat."}}};
    int at = static_cast<int>(scene.arrows.at);
    const float width = ImGui::GetContentRegionAvail().x, gap = look.px(6), half = std::floor((width - gap) / 2);
    ImGui::SetNextItemWidth(width);
    if (segmented(look, "at", at, kPlaces)) scene.arrows.at = static_cast<ArrowPlacement>(at);
    ImGui::SetNextItemWidth(width);
    number_bar(look, "##length", scene.arrows.length,
               {.letter = "length",
                .low = 0.01,
                .high = 0.5,
                .zero = 0.01,
                .range = {0.001, 10},
                .about = "In diameters of the object.",
                .rest = Arrows{}.length});
    ImGui::SetNextItemWidth(half);
    number_bar(look, "##every", scene.arrows.every,
               {.letter = "every n-th",
                .low = 1,
                .high = 32,
                .zero = 1,
                .range = {1, 1e9},
                .about = "Every n-th vertex or face has an arrow.",
                .rest = Arrows{}.every});
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(half);
    number_bar(look, "##limit", scene.arrows.limit,
               {.letter = "at most",
                .low = 0,
                .high = 1000,
                .range = {0, 1e6},
                .about = "At most so many of a kind, spread evenly.",
                .rest = Arrows{}.limit});
}

void picture_section(Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    if (!section(look, "Picture")) return;
    const float width = ImGui::GetContentRegionAvail().x, gap = look.px(6), half = std::floor((width - gap) / 2);
    static constexpr std::array<Segment, 3> kColors{
        {{"light", "Shaded with the chosen rule's normals: wrong normals show as wrong light."},
         {"error map", "Coloured by the angle between M n, or the mistake in its place, and the true normal. (E)"},
         {"normals", "Coloured by the chosen rule's normals: n·½ + ½ as red, green and blue, without light. (E)"}}};
    int color = static_cast<int>(scene.color);
    ImGui::SetNextItemWidth(width);
    if (segmented(look, "color", color, kColors)) scene.color = static_cast<SurfaceColor>(color);

    static constexpr std::array<Toggle, 9> kToggles{{
        {"ghost", "The untransformed object. (G)", &Shown::ghost},
        {"ground grid", "The ground and the object's shadow on it.", &Shown::grid},
        {"axes", "The object's axes; drag their knobs in the picture to stretch it.", &Shown::axes},
        {"tangent plane", "At the probe, with the right-angle marks.", &Shown::tangent_plane},
        {"probe", "The probe's own arrows, arc and labels.", &Shown::probe},
        {"legend", "What the colours mean.", &Shown::legend},
        {"stretch axes",
         "The perpendicular directions that M only stretches, and the normals that the naive rule treats worst.",
         &Shown::stretch_axes},
        {"sheets",
         "At the probe, the normal as a stack of sheets that M carries along, and how many of them a step along each "
         "axis "
         "and one along the surface cross.",
         &Shown::sheets},
        {"polygon H",
         "At the probe, in the tangent plane's place: the face or a pentagon, H, with its edges, and MH. (O)",
         &Shown::polygon},
    }};
    const float left = ImGui::GetCursorPosX();
    push_small_boxes(look);
    for (std::size_t i = 0; i < kToggles.size(); ++i) {
        if (i % 2 == 1) ImGui::SameLine(left + half + gap);
        ImGui::Checkbox(kToggles[i].label, &(scene.show.*kToggles[i].value));
        tip(look, kToggles[i].about);
    }
    ImGui::SameLine(left + half + gap);
    ImGui::Checkbox("renormalise", &scene.renormalise);
    tip(look,
        "Make the normals unit again at each pixel, after they were interpolated between the vertices: in between "
        "they come out too short.");
    ImGui::Checkbox("cull backs", &scene.cull);
    tip(look,
        "Leave out the triangles whose winding shows their back, as many programs do to save time: a reflection "
        "reverses the winding, and what is left is the far side.");
    ImGui::PopStyleVar();

    dim_text(look, "light from");
    direction_bars(look, "light", scene.light.azimuth, scene.light.elevation,
                   {"azimuth", "To the right of looking along −z. Shift+drag in the picture moves the light, too.",
                    Scene{}.light.azimuth},
                   {"elevation", "Above the horizon.", Scene{}.light.elevation});
}

}  // namespace normalscope

#include "ui/panel/panel.h"

#include "ui/kit/widgets.h"
#include "ui/panel/panel_memory.h"

namespace normalscope {

void draw_panel(Scene& scene, PanelMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    const PixelRect& picture = context.frame.rect;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    // In a narrow window, what is open at the other side reaches below this.
    const bool over_side = context.side.open && static_cast<float>(picture.origin.x + picture.size.x) >= screen.x;
    const glm::vec2 at(context.place.origin), room(context.place.size);
    begin_beside(picture, "##panel", {at.x, at.y}, {room.x, room.y}, 0, over_side);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::GetWindowDrawList()->AddLine({low.x + size.x - 1, low.y}, {low.x + size.x - 1, low.y + size.y},
                                        packed(look.line));

    // What a lecture switches all the time stays where it is; the rest scrolls.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(16), look.px(10)));
    const bool always = ImGui::BeginChild("##always", {size.x - 1, 0},
                                          ImGuiChildFlags_AlwaysUseWindowPadding | ImGuiChildFlags_AutoResizeY,
                                          ImGuiWindowFlags_NavFlattened);
    ImGui::PopStyleVar();
    if (always) {
        toolbar(scene, memory, context);
        rule_buttons(scene, context);
        naive_place(scene, context);
        view_buttons(scene, context);
        side_buttons(look, context.tabs, context.side, context.unfolded.tabs);
    }
    ImGui::EndChild();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);

    // The scroll bar stands in the margin, so that all ends where the buttons above do.
    const float bar = ImGui::GetStyle().ScrollbarSize, right = look.px(16) - bar;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(right, 0));
    const bool rest = ImGui::BeginChild("##rest", {size.x - 1, 0}, ImGuiChildFlags_AlwaysUseWindowPadding,
                                        ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_AlwaysVerticalScrollbar);
    ImGui::PopStyleVar();
    if (rest) {
        ImGui::Indent(look.px(16) - right);
        stack_section(look, scene, memory.stack, context.unfolded.matrix);
        // What is typed comes before what follows from it.
        const bool formula = std::holds_alternative<FormulaSurface>(scene.surface);
        if (formula) surface_section(scene, memory, context);
        singular_section(scene, context);
        slice_section(scene, context);
        if (!context.asking) probe_section(scene, memory, context);
        if (!formula) surface_section(scene, memory, context);
        arrows_section(scene, context);
        picture_section(scene, context);
        ImGui::Dummy({0, look.px(8)});
    }
    ImGui::EndChild();
    ImGui::End();
}

}  // namespace normalscope

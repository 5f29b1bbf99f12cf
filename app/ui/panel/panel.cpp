#include "ui/panel/panel.h"

#include "core/lessons/lesson.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panel_memory.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace normalscope {

namespace {

constexpr float kIconSide = 27.0f;

void scene_menu(PanelMemory& memory, const PanelContext& context, float width) {
    const Look& look = context.look;
    const std::string& file = context.status.file;
    if (!begin_combo(look, "##scenes", file.empty() ? "scenes" : std::filesystem::path(file).filename().string(),
                     width)) {
        tip(look, "Lessons, and built-in scenes to start from.");
        return;
    }
    if (memory.scenes.empty()) memory.scenes = built_in_scenes();
    ImGui::PushFont(look.fonts.small);
    dim_text(look, "Lessons");
    ImGui::PopFont();
    for (const BuiltInLesson& lesson : built_in_lessons()) {
        if (ImGui::Selectable(lesson.title.c_str(), lesson.name == file)) context.requests.open = lesson.name;
        tip(look, lesson.about.c_str());
    }
    if (ImGui::Selectable("Exercises: where does this normal go?", file.starts_with("exercises")))
        context.requests.open = "exercises";
    tip(look, "Predict, then see: endless exercises from easy to hard.");
    ImGui::Separator();
    ImGui::PushFont(look.fonts.small);
    dim_text(look, "Scenes");
    ImGui::PopFont();
    const auto group = [](const BuiltInScene& scene) {
        return scene.name.starts_with("bug-") ? 2 : scene.name.starts_with(kGalleryPrefix) ? 1 : 0;
    };
    constexpr std::array<const char*, 3> kGroups{"", "Surfaces by formula", "Gallery of bugs"};
    for (int g = 0; g < 3; ++g) {
        if (g > 0) {
            ImGui::Separator();
            ImGui::PushFont(look.fonts.small);
            dim_text(look, kGroups.at(static_cast<std::size_t>(g)));
            ImGui::PopFont();
        }
        for (const BuiltInScene& scene : memory.scenes) {
            if (group(scene) != g) continue;
            if (ImGui::Selectable(scene.name.c_str(), scene.name == file)) context.requests.open = scene.name;
            tip(look, scene.about.c_str());
        }
    }
    ImGui::EndCombo();
}

void share_menu(const PanelContext& context) {
    const Look& look = context.look;
    if (icon_button(look, "##share",
                    {.icon = Icon::Share, .about = "Share: a link, or the equations as LaTeX", .side = kIconSide}))
        ImGui::OpenPopup("##sharing");
    if (!ImGui::BeginPopup("##sharing")) return;
    if (ImGui::MenuItem("Copy link", "Ctrl+L")) context.requests.copy_link = true;
    tip(look, "The whole scene as one line of text: whoever pastes it with Ctrl+V sees what you see.");
    if (ImGui::MenuItem("Copy equations as LaTeX", "Ctrl+Shift+L")) context.requests.copy_equations = true;
    ImGui::EndPopup();
}

}  // namespace

void toolbar(Scene& scene, PanelMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    constexpr int kIcons = 8;
    const float side = look.px(kIconSide), gap = look.px(2);
    scene_menu(memory, context, ImGui::GetContentRegionAvail().x - kIcons * (side + gap) - look.px(4));
    ImGui::SameLine(0, look.px(4) + gap);
    if (icon_button(look, "##open",
                    {.icon = Icon::Open, .about = "Open a scene or a mesh… (Ctrl+O)", .side = kIconSide}))
        context.dialog.open(FileDialog::For::OpenAny);
    ImGui::SameLine(0, gap);
    if (icon_button(
            look, "##save",
            {.icon = Icon::Save, .about = "Save the scene (Ctrl+S; by another name: Ctrl+Shift+S)", .side = kIconSide}))
        context.requests.save = true;
    ImGui::SameLine(0, gap);
    if (icon_button(look, "##picture",
                    {.icon = Icon::Picture, .about = "Save the picture… (Ctrl+P)", .side = kIconSide}))
        context.dialog.open(FileDialog::For::SavePicture);
    ImGui::SameLine(0, gap);
    share_menu(context);
    ImGui::SameLine(0, gap);
    if (icon_button(
            look, "##undo",
            {.icon = Icon::Undo, .about = "Undo (Ctrl+Z)", .enabled = context.status.can_undo, .side = kIconSide}))
        context.requests.undo = true;
    ImGui::SameLine(0, gap);
    if (icon_button(look, "##redo",
                    {.icon = Icon::Redo,
                     .about = "Redo (Ctrl+Shift+Z)",
                     .enabled = context.status.can_redo,
                     .side = kIconSide}))
        context.requests.redo = true;
    ImGui::SameLine(0, gap);
    const bool dark = is_dark(scene.theme);
    if (icon_button(look, "##theme",
                    {.icon = dark ? Icon::Sun : Icon::Moon,
                     .about = dark ? "Light theme (T)" : "Dark theme (T)",
                     .side = kIconSide}))
        scene.theme = toggled(scene.theme);
    ImGui::SameLine(0, gap);
    if (icon_button(look, "##help", {.icon = Icon::Help, .about = "Mouse and keys (F1)", .side = kIconSide}))
        context.help = !context.help;
}

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
        side_buttons(look, context.tabs, context.side);
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
        stack_section(look, scene, memory.stack);
        // What is typed comes before what follows from it.
        const bool formula = std::holds_alternative<FormulaSurface>(scene.surface);
        if (formula) surface_section(scene, memory, context);
        singular_section(scene, context);
        slice_section(scene, context);
        probe_section(scene, memory, context);
        if (!formula) surface_section(scene, memory, context);
        arrows_section(scene, context);
        picture_section(scene, context);
        ImGui::Dummy({0, look.px(8)});
    }
    ImGui::EndChild();
    ImGui::End();
}

}  // namespace normalscope

#include "ui/panel/panel.h"

#include "ui/kit/own_keys.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panel_memory.h"

#include <array>
#include <filesystem>

namespace normalscope {

namespace {

constexpr float kIconSide = 27.0f;

void scene_menu(PanelMemory& memory, const PanelContext& context, float width) {
    const Look& look = context.look;
    const std::string& file = context.status.file;
    if (!begin_combo(look, "##scenes", file.empty() ? "Scenes" : std::filesystem::path(file).filename().string(),
                     width)) {
        tip(look, "Built-in scenes to start from.");
        return;
    }
    if (memory.scenes.empty()) memory.scenes = built_in_scenes();
    const auto group = [](const BuiltInScene& scene) {
        return scene.name.starts_with("bug-") ? 2 : scene.name.starts_with(kGalleryPrefix) ? 1 : 0;
    };
    constexpr std::array<const char*, 3> kGroups{"Shapes and maps", "Surfaces by formula", "Gallery of bugs"};
    for (int g = 0; g < 3; ++g) {
        if (g > 0) ImGui::Separator();
        ImGui::PushFont(look.fonts.small);
        dim_text(look, kGroups.at(static_cast<std::size_t>(g)));
        ImGui::PopFont();
        for (const BuiltInScene& scene : memory.scenes) {
            if (group(scene) != g) continue;
            if (ImGui::Selectable(scene.name.c_str(), scene.name == file)) context.requests.open = scene.name;
            tip(look, scene.about.c_str());
        }
    }
    ImGui::EndCombo();
}

void share_menu(Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    if (icon_button(
            look, "##share",
            {.icon = Icon::Share, .about = "Share: the picture, a link, HTML, the equations", .side = kIconSide}))
        ImGui::OpenPopup("##sharing");
    if (!ImGui::BeginPopup("##sharing")) return;
    const auto item = [](const char* label, const char* keys) {
        return ImGui::MenuItem(label, with_own_keys(keys).c_str());
    };
    if (item("Save picture…", "Ctrl+P")) context.dialog.open(FileDialog::For::SavePicture);
    if (item("Copy link", "Ctrl+L")) context.requests.copy_link = true;
    tip(look, "The whole scene as one line of text: anyone who pastes it with Ctrl+V sees what you see.");
    if (ImGui::MenuItem("Copy HTML for a web page")) context.requests.copy_frame = true;
    tip(look, "HTML that shows this scene in a page of your own. Put normalscope.html beside that page.");
    if (item("Copy equations as LaTeX", "Ctrl+Shift+L")) context.requests.copy_equations = true;
    if (item("Copy as a command", "Ctrl+C")) context.requests.copy_command = true;
    tip(look, "The command line that captures this picture.");
    ImGui::Separator();
    if (ImGui::MenuItem("Dark theme", "T", is_dark(scene.theme))) scene.theme = toggled(scene.theme);
    ImGui::EndPopup();
}

}  // namespace

void toolbar(Scene& scene, PanelMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    constexpr int kIcons = 6;
    const float side = look.px(kIconSide), gap = look.px(2);
    learn_menu(scene, memory, context);
    ImGui::SameLine(0, look.px(6));
    scene_menu(memory, context, ImGui::GetContentRegionAvail().x - kIcons * (side + gap) - look.px(4));
    ImGui::SameLine(0, look.px(4) + gap);
    const auto button = [&](const char* id, const IconButton& icon) {
        const bool pressed = icon_button(look, id, icon);
        ImGui::SameLine(0, gap);
        return pressed;
    };
    if (button("##open",
               {.icon = Icon::Open, .about = "Open a scene, a lesson or a mesh… (Ctrl+O)", .side = kIconSide}))
        context.dialog.open(FileDialog::For::OpenAny);
    if (button("##save",
               {.icon = Icon::Save,
                .about = context.status.draft.lesson ? "Save the lesson (Ctrl+S; by another name: Ctrl+Shift+S)"
                                                     : "Save the scene (Ctrl+S; by another name: Ctrl+Shift+S)",
                .side = kIconSide}))
        context.requests.save = true;
    share_menu(scene, context);
    ImGui::SameLine(0, gap);
    if (button("##undo",
               {.icon = Icon::Undo, .about = "Undo (Ctrl+Z)", .enabled = context.status.can_undo, .side = kIconSide}))
        context.requests.undo = true;
    if (button("##redo", {.icon = Icon::Redo,
                          .about = "Redo (Ctrl+Shift+Z)",
                          .enabled = context.status.can_redo,
                          .side = kIconSide}))
        context.requests.redo = true;
    if (icon_button(look, "##help", {.icon = Icon::Help, .about = "Mouse and keys (F1)", .side = kIconSide}))
        context.help = !context.help;
}

}  // namespace normalscope

#include "ui/panel/gallery.h"

#include "core/base/error.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr int kColumns = 5;

// A button with its picture; true where it is pressed.
bool tile(const Look& look, const GalleryMemory& memory, std::size_t i, float side, bool chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? look.line : look.field);
    const bool pressed = ImGui::Button(("##" + memory.scenes[i].name).c_str(), {side, side});
    ImGui::PopStyleColor();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (const auto picture = memory.previews.tile(i))
        list.AddImage(ImGui::GetIO().Fonts->TexID, low, high, picture->low, picture->high);
    if (chosen)
        list.AddRect(low, high, packed(look.accent), ImGui::GetStyle().FrameRounding, 0, std::max(1.0f, look.px(1.5f)));
    return pressed;
}

// The surface alone: the transform, the camera and all else stay.
void take_surface(Scene& scene, const std::string& name, const PanelContext& context) {
    try {
        const Scene from = load_scene(name);
        scene.surface = from.surface;
        scene.about = from.about;
        scene.probe.reset();  // it was a point of another surface
        context.requests.make_room = true;
    } catch (const Error&) {  // a built-in scene can be read; a test opens them all
    }
}

void keep_in_place(GalleryMemory& memory, float at, const std::string& file) {
    if (ImGui::GetIO().MouseWheel != 0.0f || ImGui::IsMouseClicked(ImGuiMouseButton_Left)) memory.place.reset();
    if (!memory.place) return;
    ImGui::SetScrollY(std::max(0.0f, ImGui::GetScrollY() + at - memory.place->at));
    const bool there = memory.place->awaited.empty() || memory.place->awaited == file;
    if (there && --memory.place->frames == 0) memory.place.reset();
}

}  // namespace

void GalleryMemory::toggle() {
    open = !open;
    place.reset();
    if (open) place.emplace();
}

void GalleryMemory::show() {
    open = wanted = true;
    place.reset();
}

void gallery(Scene& scene, GalleryMemory& memory, const PanelContext& context) {
    if (!memory.open) return;
    if (memory.wanted) ImGui::SetScrollHereY(0.05f);
    memory.wanted = false;
    const Look& look = context.look;
    const float at = ImGui::GetCursorScreenPos().y - ImGui::GetWindowPos().y;
    keep_in_place(memory, at, context.status.file);
    if (memory.scenes.empty()) {
        memory.scenes = built_in_scenes();
        std::erase_if(memory.scenes, [](const BuiltInScene& s) { return !s.name.starts_with(kGalleryPrefix); });
    }
    const float gap = look.px(4);
    const float side = std::floor((ImGui::GetContentRegionAvail().x - (kColumns - 1) * gap) / kColumns);
    std::vector<std::string> names;
    for (const BuiltInScene& s : memory.scenes) names.push_back(s.name);
    memory.previews.want(names, static_cast<int>(side));

    ImGui::Checkbox("Keep the transform and the camera", &memory.only_surface);
    tip(look, "A choice changes the surface alone.");

    // Above the tiles, where it is seen in a low window, too; as high whatever it says, so that nothing moves below the
    // pointer.
    ImGui::PushFont(look.fonts.small);
    const ImVec2 told_at = ImGui::GetCursorScreenPos();
    const float height = 2 * ImGui::GetTextLineHeight() + look.px(4);
    ImGui::PushTextWrapPos(0);
    if (memory.told)
        ImGui::TextUnformatted(memory.scenes[*memory.told].about.c_str());
    else
        dim_text(look, "Each shows something about normals: point at one, or go there with the arrow keys.");
    ImGui::PopTextWrapPos();
    ImGui::SetCursorScreenPos({told_at.x, told_at.y + height});
    ImGui::PopFont();

    std::optional<std::size_t> hovered, focused;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    for (std::size_t i = 0; i < memory.scenes.size(); ++i) {
        if (i % kColumns != 0) ImGui::SameLine(0, gap);
        const BuiltInScene& entry = memory.scenes[i];
        const bool pressed = tile(look, memory, i, side, entry.name == context.status.file);
        if (ImGui::IsItemHovered()) hovered = i;
        if (ImGui::IsItemFocused()) focused = i;
        if (pressed) {
            memory.place = GalleryPlace{at, memory.only_surface ? "" : entry.name};
        }
        if (pressed && memory.only_surface) take_surface(scene, entry.name, context);
        if (pressed && !memory.only_surface) context.requests.open = entry.name;
    }
    ImGui::PopStyleVar();
    memory.told = hovered ? hovered : focused;
}

}  // namespace normalscope

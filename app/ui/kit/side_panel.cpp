#include "ui/kit/side_panel.h"

#include "ui/kit/widgets.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace normalscope {

namespace {

struct Row {
    std::vector<std::size_t> tabs;  ///< those that stand in it
    float width = 0.0f;
    bool again_closes = false;  ///< pressing the open one
};

// Buttons as wide as their words want, the open tab's marked below.
void tab_row(const Look& look, std::span<const SideTab> tabs, SideMemory& memory, const Row& row) {
    std::vector<float> widths;
    float words = 0.0f;
    for (const std::size_t i : row.tabs) {
        const ImFont* font = look.fonts.strong;
        widths.push_back(font->CalcTextSizeA(font->FontSize, 1e9f, 0, tabs[i].label).x);
        words += widths.back();
    }
    const float room =
        std::max(0.0f, row.width - words) / static_cast<float>(std::max<std::size_t>(row.tabs.size(), 1));
    float left = ImGui::GetCursorPosX();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, ImGui::GetStyle().FramePadding.y));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    for (std::size_t k = 0; k < row.tabs.size(); ++k) {
        const std::size_t i = row.tabs[k];
        const float each = std::floor(widths[k] + room);
        if (k > 0) ImGui::SameLine(left);
        left += each;
        const bool open = memory.open == i;
        ImGui::PushStyleColor(ImGuiCol_Text, open ? look.text : look.dim);
        ImGui::PushFont(look.fonts.strong);
        const bool pressed = ImGui::Button(tabs[i].label, {each - look.px(2), look.px(28)});
        ImGui::PopFont();
        ImGui::PopStyleColor();
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        list.AddLine({low.x, high.y}, high, packed(look.line));
        if (open)
            list.AddRectFilled({low.x + look.px(4), high.y - look.px(1)}, {high.x - look.px(4), high.y + look.px(2)},
                               packed(look.accent), look.px(1));
        tip(look, tabs[i].about);
        if (!pressed) continue;
        if (open && row.again_closes)
            memory.open.reset();
        else
            memory.open = i;
    }
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

}  // namespace

void side_buttons(const Look& look, std::span<const SideTab> tabs, SideMemory& memory, bool& all) {
    constexpr float kMore = 28.0f;
    Row row{.width = ImGui::GetContentRegionAvail().x - look.px(kMore), .again_closes = true};
    for (std::size_t i = 0; i < tabs.size(); ++i)
        if (all || tabs[i].at_first || memory.open == i) row.tabs.push_back(i);
    tab_row(look, tabs, memory, row);
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - look.px(kMore));
    if (icon_button(look, "##tabs",
                    {.icon = all ? Icon::Left : Icon::More,
                     .about = all ? "Fewer tabs." : "More: classes of maps, and what a ray tracer does.",
                     .side = kMore}))
        all = !all;
}

void draw_side_panel(Scene& scene, std::span<const SideTab> tabs, SideMemory& memory, const SideContext& context,
                     float width) {
    if (!memory.open || *memory.open >= tabs.size()) return;
    const Look& look = context.look;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const bool only_tabs = !tabs[*memory.open].draw;
    const float height = only_tabs ? look.px(kTabsHeight) : screen.y;
    begin_beside(context.frame.rect, "##side", {screen.x - width, 0}, {width, height});
    const ImVec2 low = ImGui::GetWindowPos();
    ImGui::GetWindowDrawList()->AddLine(low, {low.x, low.y + height}, packed(look.line));

    const float close = look.px(30), margin = look.px(16);
    ImGui::SetCursorPos({margin, look.px(8)});
    bool closed = false;
    if (look.still) {
        ImGui::PushFont(look.fonts.strong);
        ImGui::TextUnformatted(tabs[*memory.open].label);
        ImGui::PopFont();
    } else {
        Row row{.width = width - margin - close - look.px(10)};
        for (std::size_t i = 0; i < tabs.size(); ++i) row.tabs.push_back(i);
        tab_row(look, tabs, memory, row);
        ImGui::SameLine(width - close - look.px(8));
        closed = icon_button(look, "##close",
                             {.icon = Icon::Close, .about = "Close this, and leave the room to the picture."});
    }

    const std::size_t open = *memory.open;
    if (only_tabs || !tabs[open].draw) {  // or it was chosen just now
        ImGui::End();
        if (closed) memory.open.reset();
        return;
    }
    // As in the panel at the left, the scroll bar stands in the margin.
    const float right = margin - ImGui::GetStyle().ScrollbarSize;
    ImGui::SetCursorPos({margin + 1, look.px(kTabsHeight)});
    if (tabs[open].head) {
        ImGui::BeginChild("##head", {width - 2 * margin - 1, 0}, ImGuiChildFlags_AutoResizeY,
                          ImGuiWindowFlags_NavFlattened);
        tabs[open].head(scene, context);
        ImGui::EndChild();
    }
    ImGui::SetCursorPosX(1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(right, 0));
    ImGui::PushStyleColor(ImGuiCol_ScrollbarGrab,
                          look.still ? ImVec4{} : ImGui::GetStyleColorVec4(ImGuiCol_ScrollbarGrab));
    ImGui::PushID(static_cast<int>(open));  // each tab scrolls by itself
    const bool shown = ImGui::BeginChild("##tab", {width - 1, 0}, ImGuiChildFlags_AlwaysUseWindowPadding,
                                         ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_AlwaysVerticalScrollbar);
    ImGui::PopStyleVar();
    // The row above may just have opened the tab that has a window of its own.
    if (shown && tabs[*memory.open].draw) {
        ImGui::Indent(margin - right);
        tabs[open].draw(scene, context);
        ImGui::Dummy({0, look.px(8)});
    }
    ImGui::EndChild();
    ImGui::PopID();
    ImGui::PopStyleColor();
    ImGui::End();
    if (closed) memory.open.reset();
}

}  // namespace normalscope

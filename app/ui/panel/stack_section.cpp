#include "ui/panel/stack_section.h"

#include "core/base/error.h"
#include "core/scene/scene_fields.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/typeset/small_matrix.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace normalscope {

namespace {

constexpr const char* kPayload = "stack entry";
constexpr Scale kRunningExample{{0.5, 2.0, 1.0}};
constexpr std::size_t kFewEntries = 4;  ///< up to which all are open at first

// What is to be done to the stack once it is no longer being walked.
struct Change {
    std::size_t from = 0;
    std::optional<std::size_t> to;  ///< empty: removed
};

void apply(const Change& change, std::vector<StackEntry>& stack, std::vector<bool>& folded) {
    if (change.from >= stack.size()) return;  // dragged, while an undo took it away
    const auto move = [&]<class T>(std::vector<T>& v) {
        const T taken = v[change.from];
        v.erase(v.begin() + static_cast<std::ptrdiff_t>(change.from));
        if (change.to) v.insert(v.begin() + static_cast<std::ptrdiff_t>(std::min(*change.to, v.size())), taken);
    };
    move(stack);
    move(folded);
}

void add_menu(const Look& look, Scene& scene, StackMemory& memory) {
    const bool full = scene.stack.size() >= kMostStackEntries;
    ImGui::BeginDisabled(full);
    if (ImGui::Button("Add…")) ImGui::OpenPopup("add");
    ImGui::EndDisabled();
    tip(look,
        full ? "There can be at most 200 transforms." : "Add a transform, which acts after those that are there.");
    if (!ImGui::BeginPopup("add")) return;
    const auto item = [&](const char* label, const char* about, const StackEntry& entry) {
        if (ImGui::MenuItem(label)) {
            scene.stack.push_back(entry);
            memory.folded.push_back(false);
        }
        tip(look, about);
    };
    item("Scale", "S(x, y, z): stretches along the axes.", Scale{});
    item("Rotate about x", "Rigid: the naive rule is right for it.", Rotate{{1, 0, 0}, 30.0});
    item("Rotate about y", "Rigid: the naive rule is right for it.", Rotate{{0, 1, 0}, 30.0});
    item("Rotate about z", "Rigid: the naive rule is right for it.", Rotate{{0, 0, 1}, 30.0});
    item("Translate", "Moves points, but neither vectors nor normals.", Translate{{0.5, 0, 0}});
    item("Shear", "Slides one coordinate along another.", Shear{.xy = 0.5});
    item("Matrix", "Any 4×4.", Matrix{});
    ImGui::EndPopup();
}

// Whether M is that of the running example, however it is made.
bool is_running_example(const Scene& scene) {
    try {
        return world_from_object(scene).matrix() == matrix(kRunningExample);
    } catch (const InputError&) {  // what_m_is says it
        return false;
    }
}

// At the right of the heading.
void buttons(const Look& look, Scene& scene, StackMemory& memory) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(9), look.px(3)));
    float width = 2 * look.px(6);
    for (const char* label : {"x ½, y 2", "Add…", "Reset"}) width += ImGui::CalcTextSize(label).x + 2 * look.px(9);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    const bool preset = accented_button(look, "x ½, y 2", is_running_example(scene));
    tip(look, "The running example: x halved, y doubled, nothing else.");
    if (preset) scene.stack = {kRunningExample};
    ImGui::SameLine(0, look.px(6));
    add_menu(look, scene, memory);
    ImGui::SameLine(0, look.px(6));
    if (ImGui::Button("Reset")) scene.stack = {Scale{}};
    tip(look, "Back to the object as it is: M = I. (R)");
    ImGui::PopStyleVar();
}

// The line with number, kind and buttons. True where the entry is open.
bool entry_header(const Look& look, std::size_t i, Scene& scene, StackMemory& memory, float whole,
                  std::optional<Change>& change) {
    StackEntry& entry = scene.stack[i];
    const float side = 26.0f, gap = look.px(1);
    const bool scale = std::holds_alternative<Scale>(entry), folded = memory.folded[i];
    const int count = folded ? 3 : scale ? 5 : 4;
    const float width = whole - static_cast<float>(count) * (look.px(side) + gap);

    // The whole left part folds, and is the handle to drag by.
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    if (ImGui::Button("##handle", {width, look.px(side)})) memory.folded[i] = !folded;
    ImGui::PopStyleColor();
    tip(look, "Drag to reorder; click to fold or unfold.");
    if (ImGui::BeginDragDropSource()) {
        ImGui::SetDragDropPayload(kPayload, &i, sizeof i);
        ImGui::Text("%zu  %s", i + 1, std::string(name(entry)).c_str());
        ImGui::EndDragDropSource();
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = from.y + look.px(side) / 2, y = middle - ImGui::GetFontSize() / 2;
    draw_icon(list, Icon::Grip, {from.x + look.px(7), middle}, look.px(13), packed(look.dim));
    const std::string number = std::to_string(i + 1), kind(name(entry));
    const float indent = look.px(26) + ImGui::CalcTextSize(number.c_str()).x;
    list.AddText({from.x + look.px(18), y}, packed(look.dim), number.c_str());
    list.AddText(look.fonts.strong, look.fonts.strong->FontSize, {from.x + indent, y}, packed(look.text), kind.c_str());
    if (folded) {
        const float start = indent +
                            look.fonts.strong->CalcTextSizeA(look.fonts.strong->FontSize, 1e9f, 0, kind.c_str()).x +
                            look.px(10);
        list.AddText({from.x + start, y}, packed(look.dim), shortened(summary(entry), width - start).c_str());
    }

    if (!folded && scale) {
        ImGui::SameLine(0, gap);
        if (icon_button(look, "##lock",
                        {.icon = memory.lock_scale ? Icon::LockClosed : Icon::LockOpen,
                         .about = memory.lock_scale ? "Locked: the three factors keep their proportions."
                                                    : "Lock the proportions of the three factors.",
                         .side = side}))
            memory.lock_scale = !memory.lock_scale;
    }
    if (!folded) {
        ImGui::SameLine(0, gap);
        if (icon_button(look, "##reset",
                        {.icon = Icon::Reset, .about = "Reset this transform to the identity.", .side = side}))
            entry = neutral(entry);
    }
    ImGui::SameLine(0, gap);
    if (icon_button(look, "##up", {.icon = Icon::Up, .about = "Act earlier.", .enabled = i > 0, .side = side}))
        change = {i, i - 1};
    ImGui::SameLine(0, gap);
    if (icon_button(look, "##down",
                    {.icon = Icon::Down, .about = "Act later.", .enabled = i + 1 < scene.stack.size(), .side = side}))
        change = {i, i + 1};
    ImGui::SameLine(0, gap);
    if (icon_button(look, "##remove", {.icon = Icon::Close, .about = "Remove.", .side = side}))
        change = {i, std::nullopt};
    return !folded;
}

void entry_card(const Look& look, std::size_t i, Scene& scene, StackMemory& memory, std::optional<Change>& change) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = look.px(8);
    ImGui::PushID(static_cast<int>(i));
    list.ChannelsSplit(2);  // the card is drawn behind, but known only when what it holds has been laid out
    list.ChannelsSetCurrent(1);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float right = low.x + ImGui::GetContentRegionAvail().x;
    ImGui::BeginGroup();
    ImGui::Dummy({0, 0});
    ImGui::Indent(pad);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(6), look.px(4)));
    const float width = right - low.x - 2 * pad;
    if (entry_header(look, i, scene, memory, width, change)) edit_entry(look, scene.stack[i], width, memory);
    ImGui::PopStyleVar();
    ImGui::Unindent(pad);
    ImGui::Dummy({0, 0});
    ImGui::EndGroup();
    const ImVec2 high{right, ImGui::GetItemRectMax().y};
    list.ChannelsSetCurrent(0);
    list.AddRectFilled(low, high, packed(look.card), look.px(8));
    list.ChannelsMerge();
    if (ImGui::BeginDragDropTarget()) {
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kPayload))
            change = {*static_cast<const std::size_t*>(payload->Data), i};
        ImGui::EndDragDropTarget();
    }
    ImGui::PopID();
}

void notice(const Look& look, const std::string& text) {
    const float pad = look.px(8), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - 2 * pad);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + width, from.y + size.y + 2 * pad}, packed(faded(look.bad, 0.12f)), look.px(6));
    list.AddRectFilled(from, {from.x + look.px(3), from.y + size.y + 2 * pad}, packed(look.bad), look.px(2));
    ImGui::SetCursorScreenPos({from.x + pad, from.y + pad});
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - 2 * pad);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SetCursorScreenPos({from.x, from.y + size.y + 2 * pad});
    ImGui::Dummy({width, 0});
}

// A quiet line that opens and closes what follows.
void fold(const Look& look, const char* title, bool& open) {
    ImGui::PushFont(look.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = look.px(20);
    ImGui::PushID(title);
    if (ImGui::Button("##fold", {ImGui::GetContentRegionAvail().x, height})) open = !open;
    ImGui::PopID();
    ImGui::PopStyleColor();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_icon(list, open ? Icon::Down : Icon::Right, {low.x + look.px(6), low.y + height / 2}, look.px(10),
              packed(look.dim));
    list.AddText({low.x + look.px(18), std::round(low.y + (height - ImGui::GetFontSize()) / 2)}, packed(look.dim),
                 title);
    ImGui::PopFont();
}

void what_m_is(const Look& look, const Scene& scene, bool& entries) {
    Transform<World, Object> m;
    try {
        m = world_from_object(scene);
    } catch (const InputError& error) {
        return notice(look, error.what());
    }
    fold(look, "The matrix M", entries);
    if (!entries) return;
    const NormalMatrices& normals = m.normal_matrices_by_rule();
    ImGui::PushFont(look.fonts.small);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float left = look.px(38);
    const float height = 4 * (ImGui::GetTextLineHeight() + look.px(3)) + look.px(6);
    ImGui::GetWindowDrawList()->AddText(look.fonts.strong, look.fonts.strong->FontSize,
                                        {from.x, from.y + (height - look.fonts.strong->FontSize) / 2},
                                        packed(look.text), "M =");
    ImGui::SetCursorScreenPos({from.x + left, from.y});
    matrix_in_brackets(look, m.matrix(), ImGui::GetContentRegionAvail().x);
    tip(look,
        "The product of the transforms, the first of which stands rightmost: M = last … first. "
        "Vectors have w = 0, so only the marked M₃ acts on them, and it alone decides what becomes of normals.");
    const float width = ImGui::GetContentRegionAvail().x, start = ImGui::GetCursorPosX();
    const auto figure = [&](float at, const char* label, const std::string& value, const char* about) {
        ImGui::SetCursorPosX(start + at * width);
        ImGui::BeginGroup();
        dim_text(look, label);
        ImGui::SameLine(0, look.px(5));
        ImGui::TextUnformatted(value.c_str());
        ImGui::EndGroup();
        tip(look, about);
    };
    figure(0.0f, "det", fixed(normals.determinant), "By what factor M changes volumes; negative where it mirrors.");
    ImGui::SameLine();
    figure(0.36f, "rank", std::to_string(normals.rank), "How many dimensions are left: 3 where M has an inverse.");
    ImGui::SameLine();
    figure(0.60f, "σ₁/σ₃", fixed(normals.condition()),
           "The largest stretch over the smallest (of M₃'s singular values). 1 for rigid maps and uniform scales: "
           "there the naive "
           "rule's direction is right. The larger it is, the farther off the naive rule can be.");
    ImGui::PopFont();
}

// Below the sliders, which must not slip away from the pointer while it drags one of them through zero.
void what_follows(const Look& look, const Scene& scene) {
    NormalMatrices normals;
    try {
        const Transform<World, Object> m = world_from_object(scene);
        if (!m.affine())
            return notice(look,
                          "M is not affine: points are divided by their w, and no 3×3 rule is right for normals.");
        normals = m.normal_matrices_by_rule();
    } catch (const InputError&) {  // what_m_is says it
        return;
    }
    if (normals.determinant < 0.0) reflection_remark(look);
    if (normals.rank == 3) return;
    notice(look, normals.rank == 2 ? "M has no inverse: it flattens the object. The inverse transpose does not exist; "
                                     "the cofactor still gives the normal."
                                   : "M has no inverse: it leaves no surface, so that there is no normal by any rule.");
}

// Whoever changes an entry sees what comes of it, also where the stack had been played no further than before it.
void let_act(Scene& scene, const std::vector<StackEntry>& before) {
    if (!scene.stack_position || scene.stack == before) return;
    const auto changed = std::ranges::mismatch(scene.stack, before).in1 - scene.stack.begin();
    if (*scene.stack_position < static_cast<double>(changed + 1)) scene.stack_position.reset();
}

}  // namespace

void stack_section(const Look& look, Scene& scene, StackMemory& memory, bool& entries_of_m) {
    const std::vector<StackEntry> before = scene.stack;
    const bool open = section(look, "Transform");
    buttons(look, scene, memory);
    if (!open) return;
    what_m_is(look, scene, entries_of_m);

    // Undo or another scene may have changed the stack.
    memory.folded.resize(scene.stack.size(), scene.stack.size() > kFewEntries);
    std::optional<Change> change;
    for (std::size_t i = 0; i < scene.stack.size(); ++i) entry_card(look, i, scene, memory, change);
    if (scene.stack.empty()) dim_text(look, "No transform: M = I.");
    what_follows(look, scene);
    if (change) apply(*change, scene.stack, memory.folded);
    let_act(scene, before);
}

}  // namespace normalscope

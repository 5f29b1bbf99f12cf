#include "ui/lecture/word_field.h"

#include "core/base/utf8.h"
#include "ui/kit/widgets.h"

#include <imgui_internal.h>  // the text that is being edited
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <optional>

namespace normalscope {

namespace {

/// What the callback of a field needs.
struct Editing {
    std::size_t most = 0;
    std::optional<float> width;  ///< of its lines, which break there
};

// What is too much goes at once, before the cursor: of what has just been typed or pasted.
void keep_to_limit(ImGuiInputTextCallbackData& data, std::size_t most) {
    while (data.CursorPos > 0 && columns({data.Buf, static_cast<std::size_t>(data.BufTextLen)}) > most) {
        int begin = data.CursorPos - 1;
        while (begin > 0 && (static_cast<unsigned char>(data.Buf[begin]) & 0xC0U) == 0x80U) --begin;
        data.DeleteChars(begin, data.CursorPos - begin);
    }
}

// A break stands in a space's place, so that nothing else moves: what Dear ImGui would undo is as it was, and so is where it
// has the cursor.
void break_lines(ImGuiInputTextCallbackData& data, float width) {
    const std::string text = broken(in_a_row({data.Buf, static_cast<std::size_t>(data.BufTextLen)}), width);
    std::ranges::copy(text, data.Buf);
    ImGuiInputTextState& state = ImGui::GetCurrentContext()->InputTextState;
    if (!data.BufDirty) ImTextStrFromUtf8(state.TextW.Data, state.TextW.Size, data.Buf, nullptr);
}

int edited(ImGuiInputTextCallbackData* data) {
    const auto& editing = *static_cast<const Editing*>(data->UserData);
    keep_to_limit(*data, editing.most);
    if (editing.width) break_lines(*data, *editing.width);
    return 0;
}

Typed draw_field(const Look& look, const WordField& field, std::string& text, std::optional<float> width) {
    constexpr ImGuiInputTextFlags kFlags = ImGuiInputTextFlags_CallbackEdit;
    Editing editing{field.most, width};
    const std::string typed = text;
    ImGui::SetNextItemWidth(-1);
    const float height =
        static_cast<float>(field.lines) * ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().FramePadding.y;
    const bool changed = field.lines == 1
                             ? ImGui::InputTextWithHint(field.id, field.hint, &text, kFlags, edited, &editing)
                             : ImGui::InputTextMultiline(field.id, &text, {-1, height}, kFlags, edited, &editing);
    Typed result{changed, ImGui::IsItemActive(), ImGui::GetItemID()};
    // Dear ImGui's Escape takes back all that was typed since the field was entered.
    if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) {
        text = typed;
        result = {};
    }
    if (columns(text) >= field.most)
        say_of_field(look, "No more than " + std::to_string(field.most) + " characters fit in here.");
    return result;
}

}  // namespace

Typed line_field(const Look& look, const WordField& field, std::string& text) {
    return draw_field(look, field, text, std::nullopt);
}

Typed word_field(const Look& look, const WordField& field, std::string& text) {
    return draw_field(look, field, text, field.lines > 1 ? std::optional(width_of_lines()) : std::nullopt);
}

void say_of_field(const Look& look, const std::string& line) {
    ImGui::PushFont(look.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, look.bad);
    ImGui::TextUnformatted(line.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

float width_of_lines() {
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::GetContentRegionAvail().x - 2 * style.FramePadding.x - style.ScrollbarSize;
}

void name_of_field(const Look& look, const char* name) {
    ImGui::PushFont(look.fonts.small);
    dim_text(look, name);
    ImGui::PopFont();
}

std::string broken(std::string words, float width) {
    std::size_t line = 0, space = std::string::npos;  // where the line begins, and where it could end
    for (std::size_t i = 0; i <= words.size(); ++i) {
        if (i < words.size() && words[i] != ' ') continue;
        if (space != std::string::npos && ImGui::CalcTextSize(&words[line], &words[0] + i).x > width) {
            words[space] = '\n';
            line = space + 1;
        }
        space = i;
    }
    return words;
}

std::string in_a_row(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}  // namespace normalscope

#include "ui/lecture/word_field.h"

#include "core/base/utf8.h"
#include "ui/kit/widgets.h"

#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>

namespace normalscope {

namespace {

// What is too much goes at once, before the cursor: of what has just been typed or pasted.
int keep_to_limit(ImGuiInputTextCallbackData* data) {
    const std::size_t most = *static_cast<const std::size_t*>(data->UserData);
    while (data->CursorPos > 0 && columns({data->Buf, static_cast<std::size_t>(data->BufTextLen)}) > most) {
        int begin = data->CursorPos - 1;
        while (begin > 0 && (static_cast<unsigned char>(data->Buf[begin]) & 0xC0U) == 0x80U) --begin;
        data->DeleteChars(begin, data->CursorPos - begin);
    }
    return 0;
}

}  // namespace

Typed line_field(const WordField& field, std::string& text) {
    constexpr ImGuiInputTextFlags kFlags = ImGuiInputTextFlags_CallbackEdit;
    std::size_t most = field.most;
    const std::string typed = text;
    ImGui::SetNextItemWidth(-1);
    const float height =
        static_cast<float>(field.lines) * ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().FramePadding.y;
    const bool changed = field.lines == 1
                             ? ImGui::InputTextWithHint(field.id, field.hint, &text, kFlags, keep_to_limit, &most)
                             : ImGui::InputTextMultiline(field.id, &text, {-1, height}, kFlags, keep_to_limit, &most);
    // Dear ImGui's Escape takes back all that was typed since the field was entered.
    if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) {
        text = typed;
        return {};
    }
    return {changed, ImGui::IsItemActive(), ImGui::GetItemID()};
}

Typed word_field(const WordField& field, std::string& text) {
    const float width = width_of_lines();
    const Typed typed = line_field(field, text);
    if (field.lines > 1 && ImGui::IsItemDeactivated()) text = broken(in_a_row(text), width);
    return typed;
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

std::string broken(const std::string& words, float width) {
    std::string text, line;
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        const std::string word = words.substr(begin, end - begin);
        const std::string longer = line.empty() ? word : line + " " + word;
        if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > width) {
            text += line + "\n";
            line = word;
        } else {
            line = longer;
        }
        begin = end + 1;
    }
    return text + line;
}

std::string in_a_row(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}  // namespace normalscope

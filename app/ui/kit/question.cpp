#include "ui/kit/question.h"

#include "ui/kit/dialog.h"
#include "ui/kit/own_keys.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <utility>

namespace normalscope {

namespace {

constexpr const char* kId = "##question";

ImGuiKey key_of_initial(const std::string& word) { return static_cast<ImGuiKey>(ImGuiKey_A + (word.front() - 'A')); }

}  // namespace

void QuestionBox::ask(Asked what, std::string title, std::string text, std::vector<std::string> choices) {
    asked_ = what;
    appearing_ = true;
    title_ = std::move(title);
    text_ = std::move(text);
    choices_ = std::move(choices);
}

std::optional<std::size_t> QuestionBox::buttons(const Look& look) const {
    std::optional<std::size_t> chosen;
    const float width = look.px(108), gap = look.px(8), all = static_cast<float>(choices_.size()) * (width + gap) - gap;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - all);
    for (std::size_t i = 0; i < choices_.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        const bool pressed = accented_button(look, choices_[i].c_str(), i == 0, {width, 0});
        if (!chosen && (pressed || ImGui::IsKeyPressed(key_of_initial(choices_[i]), false))) chosen = i;
    }
    const bool enter = ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false);
    if (enter && !ImGui::GetIO().NavVisible) chosen = 0;  // else it presses the button that it stands on
    return chosen;
}

void QuestionBox::draw(const Look& look, Requests& requests) {
    if (!asked_) return;
    if (std::exchange(appearing_, false)) ImGui::OpenPopup(kId);
    const bool visible = begin_dialog(look, kId, 460);
    std::optional<std::size_t> chosen;
    if (visible) {
        ImGui::PushFont(look.fonts.strong);
        ImGui::TextUnformatted(title_.c_str());
        ImGui::PopFont();
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(with_own_keys(text_).c_str());
        ImGui::PopTextWrapPos();
        ImGui::Dummy({0, look.px(4)});
        chosen = buttons(look);
        if (chosen) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    } else {
        chosen = choices_.size() - 1;  // Escape closes modals that have the keyboard
    }
    if (!chosen && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) chosen = choices_.size() - 1;
    if (!chosen) return;
    requests.reply = Reply{*asked_, *chosen};
    asked_.reset();
}

}  // namespace normalscope

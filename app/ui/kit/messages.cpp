#include "ui/kit/messages.h"

#include "ui/kit/own_keys.h"
#include "ui/kit/picture_labels.h"
#include "ui/kit/widgets.h"

#include <imgui_internal.h>  // BringWindowToDisplayFront: above help and panel

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

constexpr double kNoteSeconds = 3.0, kFadeSeconds = 0.3;

}  // namespace

void Messages::show_error(std::string_view line) {
    text_ = line;
    error_ = fresh_ = true;
}

void Messages::show_note(std::string_view line) {
    if (error_ && !text_.empty()) return;  // what must be seen is not covered by what need not
    text_ = with_own_keys(line);
    error_ = false;
    fresh_ = true;
}

void Messages::take_back(std::string_view note) {
    if (!error_ && !text_.empty() && text_ == with_own_keys(note)) text_.clear();
}

bool Messages::dismiss() {
    if (text_.empty() || !error_) return false;
    text_.clear();
    return true;
}

double Messages::redraw_after() const {
    if (text_.empty()) return std::numeric_limits<double>::infinity();
    if (fresh_) return 0.0;
    if (error_) return std::numeric_limits<double>::infinity();
    const double left = kNoteSeconds - kFadeSeconds - (now_ - since_);
    return left > 0.0 ? left : 1.0 / 30.0;
}

void Messages::draw(const Look& look, const Frame& frame) {
    now_ = ImGui::GetTime();
    if (fresh_) since_ = now_;
    fresh_ = false;
    if (!error_ && now_ - since_ >= kNoteSeconds) text_.clear();
    if (text_.empty()) return;

    const float alpha =
        error_ ? 1.0f : static_cast<float>(std::clamp((kNoteSeconds - (now_ - since_)) / kFadeSeconds, 0.0, 1.0));
    const float left = static_cast<float>(frame.rect.origin.x), whole = static_cast<float>(frame.rect.size.x),
                margin = look.px(14);
    const float close = error_ ? look.px(34) : 0.0f, pad = look.px(18);
    const float most = std::max(look.px(120), std::min(whole - 2 * margin, look.px(760)));
    const ImVec2 text = ImGui::CalcTextSize(text_.c_str(), nullptr, false, most - 2 * pad - close);
    const ImVec2 size{text.x + 2 * pad + close, text.y + look.px(18)};

    ImGui::SetNextWindowPos({std::round(left + (whole - size.x) / 2),
                             static_cast<float>(frame.rect.origin.y) + std::max(margin, titles_height(look, frame))});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, alpha);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pad, look.px(9)));
    ImGui::Begin("##message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | (error_ ? 0 : ImGuiWindowFlags_NoInputs));
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    if (error_) {
        const ImVec2 low = ImGui::GetWindowPos();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PushClipRectFullScreen();
        list.AddRectFilled({low.x + look.px(5), low.y + look.px(9)}, {low.x + look.px(9), low.y + size.y - look.px(9)},
                           packed(look.bad), look.px(2));
        list.PopClipRect();
    }
    ImGui::PushTextWrapPos(size.x - pad - close + 1);
    ImGui::TextUnformatted(text_.c_str());
    ImGui::PopTextWrapPos();
    if (error_) {
        ImGui::SetCursorPos({size.x - look.px(36), look.px(5)});
        if (icon_button(look, "##dismiss", {.icon = Icon::Close, .about = "Dismiss (Esc)", .side = 28})) text_.clear();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace normalscope

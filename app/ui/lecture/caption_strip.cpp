#include "ui/lecture/caption_strip.h"

#include "ui/kit/widgets.h"
#include "ui/typeset/math_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace normalscope {

namespace {

/// Puts boxes below each other.
class Column {
public:
    Column(const Look& look, ImVec2 at) : look_(look), at_(at) {}
    void put(const MathBox& box) {
        draw_math(*ImGui::GetWindowDrawList(), look_, box, {at_.x, std::round(at_.y + box.ascent)});
        at_.y += box.height() + look_.px(kStripGap);
    }
    ImVec2 at() const { return at_; }
    void skip(float height) { at_.y += height; }

private:
    const Look& look_;
    ImVec2 at_;
};

// A choice as a button with its letter, which is also its key.
bool choice_button(const Look& look, const Speech& speech, std::size_t i, bool chosen, ImVec2 at, ImVec2 size) {
    const Choice& choice = speech.question->choices[i];
    ImGui::SetCursorScreenPos(at);
    const ImVec4 mark = !chosen ? look.dim : choice.right ? look.good : look.bad;
    const bool pressed = ImGui::Button(("##choice" + std::to_string(i)).c_str(), size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen)
        list.AddRect(at, {at.x + size.x, at.y + size.y}, packed(mark), ImGui::GetStyle().FrameRounding, 0, look.px(2));
    const MathBox box = choice_box(look, speech, choice, size.x);
    const float baseline = std::round(at.y + (size.y - box.height()) / 2 + box.ascent);
    const std::string letter(1, static_cast<char>('A' + i));
    const ImFont& strong = speech.to_a_room ? *look.fonts.title : *look.fonts.strong;
    list.AddText(&strong, strong.FontSize, {at.x + look.px(11), std::round(baseline - strong.Ascent)}, packed(mark),
                 letter.c_str());
    draw_math(list, look, box, {at.x + choice_indent(look, speech), baseline});
    return pressed;
}

void draw_question(const Look& look, const Speech& speech, const StripState& state, float width, Column& column,
                   StripRequests& requests) {
    const Question& question = *speech.question;
    column.skip(above_question(look, speech));
    column.put(question_box(look, speech, question.text, width, Ink::Plain));
    const std::size_t columns = choice_columns(look, speech, width);
    const float each = choice_width(look, columns, width);
    for (std::size_t i = 0; i < question.choices.size(); i += columns) {
        const std::size_t end = std::min(i + columns, question.choices.size());
        float row = 0.0f;
        for (std::size_t k = i; k < end; ++k)
            row = std::max(row, choice_box(look, speech, question.choices[k], each).height());
        row += look.px(10);
        for (std::size_t k = i; k < end; ++k) {
            const ImVec2 at{column.at().x + static_cast<float>(k - i) * (each + look.px(kStripGap)), column.at().y};
            if (choice_button(look, speech, k, state.answer == k, at, {each, row})) requests.choose = k;
        }
        column.skip(row + look.px(5));
    }
    if (!state.answer) return;
    const Choice& chosen = question.choices[*state.answer];
    column.put(question_box(look, speech, verdict(chosen), width, chosen.right ? Ink::Good : Ink::Bad));
}

float text_button_width(const Look& look, const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x + look.px(10);
}

// Ends at `right`, which it moves to its own left.
bool text_button(const Look& look, const char* label, const char* about, bool enabled, float& right) {
    const float side = look.px(30);
    right -= text_button_width(look, label);
    ImGui::SetCursorPos({right, look.px(4) + std::round((side - ImGui::GetFrameHeight()) / 2)});
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label);
    ImGui::EndDisabled();
    tip(look, about);
    return pressed;
}

// At the right: where one is, and the way on.
float draw_ways(const Look& look, const StripState& state, float right, StripRequests& requests) {
    const float side = look.px(30);
    float x = right;
    if (state.closes) {
        x -= side;
        ImGui::SetCursorPos({x, look.px(4)});
        const char* about = state.count > 0 ? "Leave the lesson; it opens again at this step. (Esc)" : "Leave. (Esc)";
        if (icon_button(look, "##leave", {.icon = Icon::Close, .about = about})) requests.close = true;
    }
    for (std::size_t i = state.actions.size(); i-- > 0;) {
        const StripAction& action = state.actions[i];
        if (text_button(look, action.label, action.about, action.enabled, x)) requests.action = i;
    }
    if (state.count == 0) return x;
    const std::string where = std::to_string(state.number + 1) + " of " + std::to_string(state.count);
    const float wide = ImGui::CalcTextSize(where.c_str()).x;
    const auto tell_where = [&](float at) {
        ImGui::SetCursorPos({at, look.px(4) + std::round((side - ImGui::GetTextLineHeight()) / 2)});
        ImGui::TextUnformatted(where.c_str());
        return at;
    };
    if (state.recorded) return tell_where(x - wide - look.px(kStripPad - 10));
    x -= side + look.px(6);
    ImGui::SetCursorPos({x, look.px(4)});
    if (icon_button(look, "##next",
                    {.icon = Icon::Right,
                     .about = state.next ? state.next : "This is the last step.",
                     .enabled = state.next != nullptr}))
        requests.next = true;
    x = tell_where(x - wide - look.px(4));
    x -= side + look.px(4);
    ImGui::SetCursorPos({x, look.px(4)});
    if (icon_button(look, "##previous",
                    {.icon = Icon::Left, .about = "Previous step (Page Up, left arrow)", .enabled = state.number > 0}))
        requests.previous = true;
    if (!state.strayed) return x;
    constexpr const char* kBack = "Back to the step";
    constexpr const char* kAbout =
        "Back to the step: the scene has been changed, and this shows it as the lesson has it. (Home)";
    if (text_button_width(look, kBack) <= x - look.px(kStripPad)) {
        requests.again = text_button(look, kBack, kAbout, true, x);
        return x;
    }
    x -= side + look.px(4);
    ImGui::SetCursorPos({x, look.px(4)});
    requests.again = icon_button(look, "##again", {.icon = Icon::Reset, .about = kAbout});
    return x;
}

// How far one is, as a line above everything.
void draw_progress(const Look& look, const StripState& state, ImVec2 low, float width) {
    if (state.count < 1) return;
    const float done = width * static_cast<float>(state.number + 1) / static_cast<float>(state.count);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + look.px(3)}, packed(look.line));
    list.AddRectFilled(low, {low.x + done, low.y + look.px(3)}, packed(look.accent));
}

// What stands beside or below the words, set off by a rule.
void draw_board(const Look& look, const Speech& speech, const StripRooms& rooms, ImVec2 low) {
    const std::vector<MathBox> rows = board_rows(look, speech, rooms.board_size);
    if (rows.empty()) return;
    const ImVec2 at{low.x + rooms.board_low.x, low.y + rooms.board_low.y};
    const bool beside = rooms.board_low.x > rooms.words_low.x;
    const ImVec2 from = beside ? ImVec2(at.x - look.px(kStripPad), at.y) : ImVec2(at.x, at.y - look.px(kStripGap)),
                 to = beside ? ImVec2(from.x, at.y + rooms.board_size.y) : ImVec2(at.x + rooms.board_size.x, from.y);
    ImGui::GetWindowDrawList()->AddLine(from, to, packed(look.line), std::max(1.0f, look.px(1)));
    Column column(look, {at.x, at.y + look.px(2)});
    for (const MathBox& row : rows) column.put(row);
}

}  // namespace

StripPlace CaptionStrip::place(const Look& look, std::span<const Speech> lesson, std::span<const Speech> held,
                               ImVec2 room) {
    const bool known = measured_ && measured_->room.x == room.x && measured_->room.y == room.y &&
                       std::ranges::equal(measured_->lesson, lesson) && std::ranges::equal(measured_->held, held);
    if (!known)
        measured_ = Measured{
            {lesson.begin(), lesson.end()}, {held.begin(), held.end()}, room, strip_place(look, lesson, held, room)};
    return measured_->place;
}

StripRequests CaptionStrip::draw(const Look& look, const Speech& speech, const StripState& state,
                                 const StripRoom& room) {
    StripRequests requests;
    const auto [low, size, side] = room;
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin("##captions", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(2);
    draw_progress(look, state, low, size.x);
    const float left = draw_ways(look, state, size.x - look.px(10), requests);
    ImGui::SetCursorPos({look.px(kStripPad), look.px(4) + std::round((look.px(30) - ImGui::GetTextLineHeight()) / 2)});
    const float for_title = left - look.px(kStripPad + 16);
    const bool whole = state.short_title.empty() || ImGui::CalcTextSize(state.title.c_str()).x <= for_title;
    const std::string title = shortened(whole ? state.title : state.short_title, for_title);
    dim_text(look, title);
    if (title != state.title) tip(look, state.title.c_str());

    const StripRooms rooms = strip_rooms(look, speech, side, size);
    draw_board(look, speech, rooms, low);
    // Where the words are more than the strip holds, they scroll; what is new on the board stays.
    ImGui::SetCursorPos({0, rooms.words_low.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ImGui::BeginChild("##words", {rooms.words_low.x + rooms.words_size.x + look.px(kStripPad), rooms.words_size.y}, 0,
                      ImGuiWindowFlags_NavFlattened);
    const float width = rooms.words_size.x;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    Column column(look, {origin.x + rooms.words_low.x, origin.y + look.px(2)});
    column.put(caption_box(look, speech, width));
    if (!speech.look_at.empty()) column.put(note_box(look, speech.look_at, width, Ink::Dim));
    if (speech.question) {
        ImGui::PushStyleColor(ImGuiCol_Button, state.recorded ? ImVec4{} : ImGui::GetStyleColorVec4(ImGuiCol_Button));
        draw_question(look, speech, state, width, column, requests);
        ImGui::PopStyleColor();
    }
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy({1, column.at().y - look.px(kStripGap) - origin.y});  // the last gap is nothing to scroll to
    if (said_ != speech) ImGui::SetScrollY(0.0f);
    said_ = speech;
    if (std::exchange(explained_, state.answer) != state.answer && state.answer)
        ImGui::SetScrollFromPosY(column.at().y - ImGui::GetWindowPos().y, 1.0f);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::End();
    return requests;
}

}  // namespace normalscope

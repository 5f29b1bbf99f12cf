#include "ui/lecture/question_fields.h"

#include "ui/kit/widgets.h"

#include <algorithm>

namespace normalscope {

namespace {

constexpr float kGap = 8.0f;  // between the mark of the right one and what it marks

}  // namespace

void QuestionFields::read(const Look& look, const LessonStep& step) {
    const float width = width_of_lines(), beside = width - ImGui::GetFrameHeight() - look.px(kGap);
    notes_ = broken(step.notes, width);
    ask_.clear();
    rows_ = {};
    right_ = 0;
    if (!step.question) return;
    ask_ = broken(step.question->text, width);
    const std::vector<Choice>& choices = step.question->choices;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        rows_[i] = {choices[i].text, broken(choices[i].because, beside)};
        if (choices[i].right) right_ = i;
    }
}

// There is always room for another one.
std::size_t QuestionFields::rows_to_show() const {
    std::size_t shown = rows_.size();
    while (shown > 2 && rows_[shown - 1].empty() && rows_[shown - 2].empty()) --shown;
    return shown;
}

std::size_t QuestionFields::right_row() const {
    if (!rows_[right_].empty()) return right_;
    const auto first = std::ranges::find_if(rows_, [](const Row& row) { return !row.empty(); });
    return first == rows_.end() ? right_ : static_cast<std::size_t>(first - rows_.begin());
}

Typed QuestionFields::draw_answer(const Look& look, std::size_t i) {
    Typed typed;
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushTabStop(false);  // Tab goes from field to field
    if (ImGui::RadioButton("##right", right_row() == i)) {
        right_ = i;
        typed = {.changed = true, .field = ImGui::GetItemID()};
    }
    ImGui::PopTabStop();
    tip(look, "The right one.");
    ImGui::SameLine(0, look.px(kGap));
    ImGui::BeginGroup();
    const std::string hint = std::string("Answer ") + static_cast<char>('A' + i);
    typed |= word_field(look, {.id = "##answer", .most = kLongestChoice, .hint = hint.c_str()}, rows_[i].text);
    typed |= word_field(look, {.id = "##because", .lines = 2, .most = kLongestNote}, rows_[i].because);
    ImGui::EndGroup();
    ImGui::PopID();
    return typed;
}

Typed QuestionFields::draw(const Look& look) {
    Typed typed;
    name_of_field(look, "What is asked");
    typed |= word_field(look, {.id = "##ask", .lines = 2, .most = kLongestNote}, ask_);
    name_of_field(look, "Answers, each with what is said of it");
    for (std::size_t i = 0, shown = rows_to_show(); i < shown; ++i) typed |= draw_answer(look, i);
    name_of_field(look, "Notes, which no picture shows");
    typed |= word_field(look, {.id = "##notes", .lines = 4, .most = kLongestNotes}, notes_);
    return typed;
}

void QuestionFields::write_to(LessonStep& step) const {
    step.notes = in_a_row(notes_);
    Question question{.text = in_a_row(ask_), .choices = {}};
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!rows_[i].empty())
            question.choices.push_back({rows_[i].text, i == right_row(), in_a_row(rows_[i].because)});
    step.question.reset();
    if (!question.text.empty() || !question.choices.empty()) step.question = std::move(question);
}

}  // namespace normalscope

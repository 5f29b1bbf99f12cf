#include "ui/lecture/lesson_editor.h"

#include "core/lessons/lesson_limits.h"
#include "ui/kit/widgets.h"
#include "ui/lecture/word_field.h"

#include <algorithm>
#include <utility>

namespace normalscope {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end > begin) lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::vector<std::string> as_many_as_fit(std::vector<std::string> equations) {
    if (equations.size() > kMostEquations) equations.resize(kMostEquations);
    return equations;
}

template <class Change>
void change(const Draft& draft, Requests& requests, Change&& how) {
    Lesson lesson = *draft.lesson;
    how(lesson);
    requests.edit = Draft{std::make_shared<const Lesson>(std::move(lesson)), draft.step};
}

}  // namespace

void LessonEditor::read(const EditedLesson& edited) {
    const float width = width_of_lines();
    if (typing_ || (shown_ == edited.draft && width_ == width)) return;
    shown_ = edited.draft;
    width_ = width;
    const LessonStep& step = edited.draft.lesson->steps.at(edited.draft.step);
    title_ = edited.draft.lesson->title;
    caption_ = broken(step.caption, width);
    look_at_ = broken(step.look_at, width);
    equations_.clear();
    for (const std::string& line : step.equations) equations_ += (equations_.empty() ? "" : "\n") + line;
    question_.read(edited.look, step);
}

void LessonEditor::words(const EditedLesson& edited, Requests& requests) {
    const Look& look = edited.look;
    const Draft& draft = edited.draft;
    typing_ = false;
    const auto changed = [&](const Typed& typed, auto&& how) {
        typing_ |= typed.typing;
        if (!typed.changed) return;
        if (std::exchange(typed_in_, typed.field) != typed.field) requests.step = true;  // of the field before
        change(draft, requests, how);
    };
    const auto step = [&](Lesson& lesson) -> LessonStep& { return lesson.steps.at(draft.step); };
    name_of_field(look, "Title");
    changed(word_field(look, {.id = "##Title", .most = kLongestNote}, title_),
            [&](Lesson& l) { l.title = title_.empty() ? "My lesson" : title_; });
    name_of_field(look, "What is said");
    changed(word_field(look, {.id = "##What is said", .lines = 4, .most = kLongestCaption}, caption_),
            [&](Lesson& l) { step(l).caption = in_a_row(caption_); });
    name_of_field(look, "What to look at");
    changed(word_field(look, {.id = "##What to look at", .lines = 2, .most = kLongestNote}, look_at_),
            [&](Lesson& l) { step(l).look_at = in_a_row(look_at_); });
    name_of_field(look, "Equations, a line each");
    changed(line_field(look, {.id = "##Equations, a line each", .lines = 3, .most = kMostEquations * kLongestNote},
                       equations_),
            [&](Lesson& l) { step(l).equations = as_many_as_fit(lines_of(equations_)); });
    if (lines_of(equations_).size() > kMostEquations)
        say_of_field(look, "Only the first " + std::to_string(kMostEquations) + " lines are shown and saved.");
    ImGui::PushTabStop(!unfolded_);  // Tab goes from field to field, but unfolds what is folded
    unfolded_ = section(look, "Question and notes", false);
    ImGui::PopTabStop();
    if (unfolded_) changed(question_.draw(look), [&](Lesson& l) { question_.write_to(step(l)); });
}

void LessonEditor::steps(const EditedLesson& edited, Requests& requests) const {
    const Look& look = edited.look;
    const Draft& draft = edited.draft;
    const Lesson& lesson = *draft.lesson;
    if (ImGui::Button("Add this view as a step", {-1, 0}))
        requests.edit =
            Draft{std::make_shared<const Lesson>(with_step_after(lesson, draft.step, edited.scene)), draft.step + 1};
    tip(look, "What you see becomes the step behind this one.");
    const auto button = [&](const char* label, const char* about, bool enabled) {
        ImGui::BeginDisabled(!enabled);
        const bool pressed = ImGui::Button(label);
        ImGui::EndDisabled();
        tip(look, about);
        ImGui::SameLine(0, look.px(6));
        return pressed;
    };
    if (button("Use this view", "What you see becomes what this step shows.", edited.strayed))
        change(draft, requests, [&](Lesson& l) {
            Scene& scene = l.steps.at(draft.step).scene;
            scene = {edited.scene};
            scene.theme = lesson.steps.at(draft.step).scene.theme;  // the room's light is no part of it
        });
    const auto moved = [&](std::size_t to) {
        requests.edit = Draft{std::make_shared<const Lesson>(with_swapped(lesson, draft.step, to)), to};
    };
    if (button("Earlier", "This step and the one before change places.", draft.step > 0)) moved(draft.step - 1);
    if (button("Later", "This step and the next change places.", draft.step + 1 < lesson.steps.size()))
        moved(draft.step + 1);
    if (button("Remove", "Ctrl+Z brings it back.", lesson.steps.size() > 1))
        requests.edit = Draft{std::make_shared<const Lesson>(without_step(lesson, draft.step)),
                              std::min(draft.step, lesson.steps.size() - 2)};
    ImGui::NewLine();
}

void LessonEditor::ending(const EditedLesson& edited, Requests& requests) const {
    const Look& look = edited.look;
    ImGui::Separator();
    if (ImGui::Button("Save")) requests.save = true;
    tip(look, "To its file, or one that you name. (Ctrl+S)");
    ImGui::SameLine(0, look.px(6));
    if (ImGui::Button("Save as…")) requests.save_lesson_as = true;
    tip(look, "To another file. (Ctrl+Shift+S)");
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize("Done").x -
                         2 * ImGui::GetStyle().FramePadding.x);
    if (ImGui::Button("Done")) requests.writing = Writing::Done;
    tip(look, "The lesson stays open; Learn has “Change this lesson”.");
}

void LessonEditor::draw(const EditedLesson& edited, Requests& requests) {
    const Look& look = edited.look;
    const bool beside = edited.side > 0.0f;
    const auto right = static_cast<float>(edited.picture.origin.x + edited.picture.size.x),
               top = static_cast<float>(edited.picture.origin.y), margin = look.px(12);
    if (beside)
        ImGui::SetNextWindowPos({ImGui::GetIO().DisplaySize.x - edited.side, 0});
    else
        ImGui::SetNextWindowPos({right - look.px(kEditorWidth) - margin, top + margin}, ImGuiCond_Appearing);
    const float width = beside ? edited.side : look.px(kEditorWidth);
    const float most = ImGui::GetIO().DisplaySize.y - (beside ? 0.0f : 2 * margin);
    const float fields = std::max(std::min(fields_, most - buttons_), look.px(80));
    ImGui::SetNextWindowSize({width, std::min(fields + buttons_, most)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, beside ? 0.0f : look.px(10));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(14), look.px(10)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, beside ? 0.0f : 1.0f);
    ImGui::Begin(beside ? "##writing" : "##writing over", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     (beside ? ImGuiWindowFlags_NoMove : 0));
    // Where the fields are more than the window holds, they scroll; the buttons stay.
    ImGui::BeginChild("##fields", {0, fields}, 0, ImGuiWindowFlags_NavFlattened);
    read(edited);
    words(edited, requests);
    fields_ = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
    ImGui::EndChild();
    ImGui::Dummy({0, look.px(2)});
    steps(edited, requests);
    ending(edited, requests);
    buttons_ = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + ImGui::GetStyle().WindowPadding.y - fields;
    has_keyboard_ = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    if (requests.edit && typing_) shown_ = *requests.edit;  // what is typed is not read back while it is
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace normalscope

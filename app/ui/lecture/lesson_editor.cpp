#include "ui/lecture/lesson_editor.h"

#include "ui/kit/widgets.h"

#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <utility>

namespace normalscope {

namespace {

// Lines as wide as the field, which Dear ImGui does not break itself.
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

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end > begin) lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

void name_of_field(const Look& look, const char* name) {
    ImGui::PushFont(look.fonts.small);
    dim_text(look, name);
    ImGui::PopFont();
}

float width_of_lines(const Look& look) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return look.px(kEditorWidth) - 2 * style.WindowPadding.x - 2 * style.FramePadding.x - style.ScrollbarSize;
}

bool field(const Look& look, const char* name, std::string& text, int lines) {
    name_of_field(look, name);
    const float height = static_cast<float>(lines) * ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().FramePadding.y;
    return ImGui::InputTextMultiline((std::string("##") + name).c_str(), &text, {-1, height});
}

template <class Change>
void change(const Draft& draft, Requests& requests, Change&& how) {
    Lesson lesson = *draft.lesson;
    how(lesson);
    requests.edit = Draft{std::make_shared<const Lesson>(std::move(lesson)), draft.step};
}

}  // namespace

void LessonEditor::read(const EditedLesson& edited) {
    if (shown_ == edited.draft || typing_) return;
    shown_ = edited.draft;
    const LessonStep& step = edited.draft.lesson->steps.at(edited.draft.step);
    const float width = width_of_lines(edited.look);
    title_ = edited.draft.lesson->title;
    caption_ = broken(step.caption, width);
    look_at_ = broken(step.look_at, width);
    equations_.clear();
    for (const std::string& line : step.equations) equations_ += (equations_.empty() ? "" : "\n") + line;
}

void LessonEditor::words(const EditedLesson& edited, Requests& requests) {
    const Look& look = edited.look;
    const Draft& draft = edited.draft;
    typing_ = false;
    const auto changed = [&](bool now, auto&& how) {
        typing_ |= ImGui::IsItemActive();
        if (now) change(draft, requests, how);
    };
    name_of_field(look, "Title");
    ImGui::SetNextItemWidth(-1);
    changed(ImGui::InputText("##Title", &title_), [&](Lesson& l) { l.title = title_.empty() ? "My lesson" : title_; });
    const auto end_lines = [&](std::string& text) {
        if (ImGui::IsItemDeactivated()) text = broken(in_a_row(text), width_of_lines(look));
    };
    const auto step = [&](Lesson& lesson) -> LessonStep& { return lesson.steps.at(draft.step); };
    changed(field(look, "What is said", caption_, 4), [&](Lesson& l) { step(l).caption = in_a_row(caption_); });
    end_lines(caption_);
    changed(field(look, "What to look at", look_at_, 2), [&](Lesson& l) { step(l).look_at = in_a_row(look_at_); });
    end_lines(look_at_);
    changed(field(look, "Equations, a line each", equations_, 3),
            [&](Lesson& l) { step(l).equations = lines_of(equations_); });
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
    ImGui::SetNextWindowSize({beside ? edited.side : look.px(kEditorWidth), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, beside ? 0.0f : look.px(10));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(14), look.px(10)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, beside ? 0.0f : 1.0f);
    ImGui::Begin(beside ? "##writing" : "##writing over", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     (beside ? ImGuiWindowFlags_NoMove : 0));
    read(edited);
    words(edited, requests);
    ImGui::Dummy({0, look.px(2)});
    steps(edited, requests);
    ending(edited, requests);
    if (requests.edit && typing_) shown_ = *requests.edit;  // what is typed is not read back while it is
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace normalscope

#include "ui/panel/panel.h"

#include "core/lessons/shelf.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panel_memory.h"

#include <algorithm>
#include <cfloat>
#include <string>

namespace normalscope {

namespace {

constexpr float kMenuWidth = 356.0f;

// A row to be chosen; what stands at its right is said quietly.
bool row(const Look& look, const char* title, const std::string& right, bool chosen) {
    const bool pressed = ImGui::Selectable(title, chosen, 0, {0, look.px(24)});
    if (right.empty()) return pressed;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImFont* small = look.fonts.small;
    const float width = small->CalcTextSizeA(small->FontSize, 1e9f, 0, right.c_str()).x;
    ImGui::GetWindowDrawList()->AddText(
        small, small->FontSize,
        {std::round(high.x - width - look.px(6)), std::round((low.y + high.y - small->FontSize) / 2)}, packed(look.dim),
        right.c_str());
    return pressed;
}

void heading(const Look& look, const char* text) {
    ImGui::PushFont(look.fonts.small);
    dim_text(look, text);
    ImGui::PopFont();
}

// How far somebody has come: "3 of 9", a tick at the end, nothing where it has not been begun.
std::string progress_of(const ListedLesson& lesson, const std::map<std::string, std::size_t>& progress) {
    const auto left_at = progress.find(lesson.name);
    if (left_at == progress.end() || lesson.steps == 0) return std::to_string(lesson.steps) + " steps";
    const std::size_t step = std::min(left_at->second, lesson.steps - 1) + 1;
    return step == lesson.steps ? "✓" : std::to_string(step) + " of " + std::to_string(lesson.steps);
}

bool is_built_in(const ListedLesson& lesson) { return is_built_in_lesson(lesson.name); }
bool is_own(const ListedLesson& lesson) { return !is_built_in(lesson); }

void lessons(const PanelContext& context, bool (*wanted)(const ListedLesson&)) {
    for (const ListedLesson& lesson : context.shelf) {
        if (!wanted(lesson)) continue;
        ImGui::PushID(lesson.name.c_str());  // two may have one title
        if (row(context.look, lesson.title.c_str(), progress_of(lesson, context.progress),
                same_lesson(lesson.name, context.status.file)))
            context.requests.open = lesson.name;
        ImGui::PopID();
        if (!lesson.about.empty()) tip(context.look, lesson.about.c_str());
    }
}

void writing(const Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    const Status& status = context.status;
    if (status.draft.lesson) {
        if (row(look, "Add this view as a step", "", false)) {
            context.requests.edit =
                Draft{std::make_shared<const Lesson>(with_step_after(*status.draft.lesson, status.draft.step, scene)),
                      status.draft.step + 1};
            context.requests.writing = Writing::ThisLesson;
        }
        tip(look, "What you see becomes the step behind this one.");
    }
    if (status.in_lesson) {
        if (row(look, "Change this lesson", "", false)) context.requests.writing = Writing::ThisLesson;
        tip(look, "Edit its words and its steps. A built-in lesson stays as it is; yours is saved under another name.");
    }
    if (row(look, "Write a lesson", "", false)) context.requests.writing = Writing::New;
    tip(look, "It begins with what you see. Add views as steps, and write words for each.");
}

}  // namespace

void learn_menu(const Scene& scene, PanelMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    const bool pressed = accented_button(look, "Learn");
    tip(look, "Lessons, exercises, and a gallery of surfaces.");
    if (pressed) ImGui::OpenPopup("##learning");
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float top = high.y + look.px(4), room = ImGui::GetIO().DisplaySize.y - top - look.px(4);
    ImGui::SetNextWindowPos({low.x, top});
    ImGui::SetNextWindowSize({look.px(kMenuWidth), 0});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, std::max(room, look.px(120))});  // it scrolls
    if (!ImGui::BeginPopup("##learning")) return;
    if (ImGui::IsWindowAppearing()) context.requests.list_lessons = true;
    heading(look, "Lessons");
    lessons(context, is_built_in);
    ImGui::Separator();
    heading(look, "Your lessons");
    lessons(context, is_own);
    writing(scene, context);
    ImGui::Separator();
    heading(look, "Exercises");
    if (row(look, "Where does this normal go?", "without end", context.status.file.starts_with("exercises")))
        context.requests.open = "exercises";
    tip(look, "Predict, then see: from easy to hard.");
    ImGui::Separator();
    heading(look, "Gallery");
    if (row(look, "Surfaces by formula", "", false)) memory.gallery.show();
    tip(look, "With their pictures, and what each shows about normals.");
    ImGui::EndPopup();
}

}  // namespace normalscope

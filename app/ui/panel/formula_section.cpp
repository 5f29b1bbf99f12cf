#include "ui/panel/formula_section.h"

#include "core/base/error.h"
#include "core/formula/parse.h"
#include "core/formula/syntax_error.h"
#include "ui/kit/number_bar.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/typeset/small_matrix.h"

#include <imgui_internal.h>  // GetInputTextState: how far the field has scrolled
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace normalscope {

namespace {

constexpr double kBetweenLetters = 0.15;  // seconds
constexpr double kPause = 1.0;            // seconds without a key: what has been typed is one step to undo
constexpr double kDefaultReach = 2.0;
constexpr int kSettled = 3;  // frames until the panel stands as the scene calls for

std::size_t letter_index(char letter) { return formulas::kParameterNames.find(letter); }

// Where in the text the column begins, which counts characters from 1.
std::size_t byte_of(std::string_view text, std::size_t column) {
    std::size_t at = 0;
    for (std::size_t i = 1; i < column && at < text.size(); ++i) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
    }
    return at;
}

}  // namespace

bool FormulaDraft::follow(const FormulaSurface& scene) {
    if (followed_ == scene.formula) return false;
    followed_ = text = scene.formula;
    mistake_.reset();
    letters_ = formulas::read(scene.formula).parameters;  // the scene's own can always be read
    return true;
}

void FormulaDraft::stay(const FormulaSurface& scene) {
    followed_ = scene.formula;
    letters_ = formulas::read(scene.formula).parameters;
}

void FormulaDraft::typed(FormulaSurface& scene) {
    for (const char letter : letters_) values_[letter_index(letter)] = scene.parameters[letter_index(letter)];
    try {
        letters_ = formulas::read(text).parameters;
        mistake_.reset();
        followed_ = scene.formula = text;
        // Letters that do not occur count for nothing: a scene has them all at 1.
        scene.parameters = formulas::kAllOne;
        for (const char letter : letters_) scene.parameters[letter_index(letter)] = values_[letter_index(letter)];
    } catch (const formulas::SyntaxError& e) {
        mistake_ = FormulaMistake{e.column, e.what()};
    } catch (const InputError& e) {
        mistake_ = FormulaMistake{0, e.what()};
    }
}

double FormulaMemory::redraw_after() const {
    if (!typed_at) return std::numeric_limits<double>::infinity();
    return std::max(0.0, *typed_at + (typing() ? kBetweenLetters : kPause) - ImGui::GetTime());
}

bool FormulaMemory::typing() const { return typed_at && ImGui::GetTime() - *typed_at < kBetweenLetters; }

namespace {

// The caret below the field points at the column, and what was expected stands beside it.
void show_mistake(const Look& look, const FormulaMistake& mistake, const std::string& text, ImVec2 low, ImVec2 high,
                  float scroll) {
    if (mistake.column > 0) {
        const std::string_view before = std::string_view(text).substr(0, byte_of(text, mistake.column));
        const float pad = ImGui::GetStyle().FramePadding.x, half = look.px(4);
        const float x = low.x + pad - scroll + ImGui::CalcTextSize(before.data(), before.data() + before.size()).x;
        const float at = std::clamp(std::round(x), low.x + half, high.x - half), y = high.y + look.px(1);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddTriangleFilled({at, y}, {at - half, y + 1.6f * half}, {at + half, y + 1.6f * half}, packed(look.bad));
        ImGui::Dummy({0, look.px(4)});
    }
    ImGui::PushFont(look.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, look.bad);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(mistake.message.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void field(Scene& scene, FormulaSurface& surface, FormulaMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    FormulaDraft& draft = memory.draft;
    const ImGuiID id = ImGui::GetID("##formula");
    if (draft.follow(surface) && ImGui::GetActiveID() == id)
        ImGui::ClearActiveID();  // the field would write its own back
    if (memory.focus) {
        ImGui::SetWindowFocus();  // else what follows is forgotten where Esc has led the keys out of this window
        ImGui::SetKeyboardFocusHere();
        ImGui::SetScrollHereY(0.15f);  // what is said of the formula stands below
    }
    if (std::exchange(memory.focus, false)) memory.selects_all = true;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (draft.mistake()) ImGui::PushStyleColor(ImGuiCol_Border, look.bad);
    const bool wrong = draft.mistake().has_value();
    if (wrong) ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, std::max(1.0f, look.px(1)));
    const bool changed = ImGui::InputTextWithHint("##formula", "f(x, y, z) = 0", &draft.text);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (wrong) {
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
    }
    const bool active = ImGui::IsItemActive();
    // A field to which the keyboard comes back selects nothing by itself.
    if (active && std::exchange(memory.selects_all, false)) ImGui::GetInputTextState(id)->SelectAll();
    // What stands above it comes and goes with the surface: it must not push out of sight what is being typed.
    if (changed) memory.frames_in_sight = kSettled;
    if (memory.frames_in_sight > 0) {
        --memory.frames_in_sight;
        if (low.y < ImGui::GetWindowPos().y) ImGui::SetScrollHereY(0.15f);
    }
    if (!active)
        tip(look,
            "f(x, y, z) = 0, where f < 0 is the inside.\n+ − * / ^, brackets, 2x, x^2 or x², lhs = rhs, pi, e, sqrt "
            "exp log "
            "ln log10 sin cos tan asin acos atan atan2 sinh cosh tanh abs sign floor mod min max …; the letters a b c "
            "d f g h are "
            "parameters.");
    if (changed) {
        const FormulaMemory::Before before{surface, scene.about};
        draft.typed(surface);
        if (surface != before.surface) {
            if (!memory.typed_at) memory.before = before;
            scene.about.clear();
        }
        if (surface != before.surface || memory.typed_at) memory.typed_at = ImGui::GetTime();
    }
    // A pause makes a step to undo, and so does whatever ends the editing; but what is wrong by then had a beginning that
    // nobody meant.
    if (memory.typed_at && (!active || ImGui::GetTime() - *memory.typed_at >= kPause)) {
        memory.typed_at.reset();
        if (draft.mistake()) {
            surface = memory.before.surface;
            scene.about = memory.before.about;
            draft.stay(surface);
        } else {
            context.requests.step = context.requests.make_room = true;
        }
    }
    if (!draft.mistake()) return;
    const ImGuiInputTextState* state = active ? ImGui::GetInputTextState(id) : nullptr;
    show_mistake(look, *draft.mistake(), draft.text, low, high, state ? state->ScrollX : 0.0f);
}

// ---- Parameters, bound and clip

void range_editor(const Look& look, const char* letter, Range& range) {
    const std::string label = brief(range.low) + " … " + brief(range.high);
    ImGui::PushFont(look.fonts.small);
    const bool pressed =
        ImGui::Button(label.c_str(), {ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight() + look.px(2)});
    ImGui::PopFont();
    tip(look, "The slider's range; any value can be typed into it.");
    if (pressed) ImGui::OpenPopup("##range");
    if (!ImGui::BeginPopup("##range")) return;
    ImGui::TextUnformatted((std::string(letter) + " goes").c_str());
    ImGui::SetNextItemWidth(look.px(120));
    number_bar(look, "##low", range.low, {.letter = "from", .step = 0.1});
    ImGui::SetNextItemWidth(look.px(120));
    number_bar(look, "##high", range.high, {.letter = "to", .step = 0.1});
    if (range.high < range.low) std::swap(range.low, range.high);
    ImGui::EndPopup();
}

void parameter(const Look& look, char letter, double& value, std::optional<Range>& range) {
    if (!range) range = Range{-kDefaultReach, kDefaultReach};
    // With room to go on beyond it.
    if (value < range->low) range->low = value - std::abs(value);
    if (value > range->high) range->high = value + std::abs(value);
    const std::string name(1, letter);
    ImGui::PushID(letter);
    const float range_width = look.px(96), gap = look.px(6);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - range_width - gap);
    const double span = range->high - range->low;
    number_bar(look, "##value", value,
               {.letter = name.c_str(),
                .low = range->low,
                .high = span > 0.0 ? range->high : range->low + 1.0,
                .zero = std::clamp(0.0, range->low, range->high),
                .step = span > 20.0  ? 0.1
                        : span > 0.5 ? 0.01
                                     : 0.001,
                .about = "A parameter of the formula.",
                .rest = 1.0,
                .catches = true});
    ImGui::SameLine(0, gap);
    range_editor(look, name.c_str(), *range);
    ImGui::PopID();
}

void bound_and_clip(const Look& look, FormulaSurface& surface) {
    const float clip_width = look.px(130), gap = look.px(6);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - clip_width - gap);
    number_bar(look, "##bound", surface.bound,
               {.letter = "bound",
                .low = 0.5,
                .high = 5.0,
                .zero = 0.5,
                .range = {1e-3, 1e3},
                .about = "How far the surface goes from the origin: the ball's radius, or half the cube's side.",
                .rest = FormulaSurface{}.bound});
    ImGui::SameLine(0, gap);
    int clip = static_cast<int>(surface.clip);
    static constexpr std::array<Segment, 2> kClips{{{"Ball", "What lies outside a ball about the origin is cut off."},
                                                    {"Cube", "What lies outside a cube about the origin is cut off."}}};
    ImGui::SetNextItemWidth(clip_width);
    if (segmented(look, "clip", clip, kClips)) surface.clip = static_cast<Clip>(clip);
}

}  // namespace

void formula_section(Scene& scene, FormulaMemory& memory, const PanelContext& context) {
    FormulaSurface* surface = std::get_if<FormulaSurface>(&scene.surface);
    if (!surface) return;
    const Look& look = context.look;
    field(scene, *surface, memory, context);
    const std::shared_ptr<const Surface>& drawn = context.frame.surface;
    if (!memory.draft.mistake() && drawn)  // else of what was typed before
        for (const std::string& note : drawn->mesh.notes) remark(look, look.accent, note);
    // The derivatives stand with their values at the probe, unless there is none.
    written_formula(look, memory.written, surface->formula, ImGui::GetContentRegionAvail().x,
                    context.frame.probe ? 1 : 4);
    for (const char letter : memory.written->parameters)
        parameter(look, letter, surface->parameters[letter_index(letter)], memory.ranges[letter_index(letter)]);
    const double bound = surface->bound;
    bound_and_clip(look, *surface);
    if (surface->bound != bound) context.requests.make_room = true;
    memory.last = *surface;
}

}  // namespace normalscope

#include "ui/tabs/ray_tab.h"

#include "core/surface/ray_steps.h"
#include "ui/kit/number_bar.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/typeset/math_layout.h"
#include "ui/typeset/small_matrix.h"

#include <glm/geometric.hpp>

#include <imgui_internal.h>  // SetKeyOwner

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace normalscope {

namespace {

constexpr float kGutter = 30.0f;  // for a step's number

struct Told {
    std::string title;
    std::vector<MathBox> boxes;  ///< in one row
    std::string words;
};

// The pieces that the steps' equations are made of.
class Writing {
public:
    explicit Writing(const Look& look) : look_(look), style_(math_style(look)) {}

    MathBox letter(const char* text, Ink ink) const { return written(style_, style_.letters, text, ink); }
    MathBox sign(const char* text) const { return written(style_, style_.upright, text, Ink::Plain); }
    MathBox words(const std::string& text, Ink ink) const { return written(style_, style_.script, text, ink); }
    MathBox number(double v, Ink ink) const { return written(style_, style_.upright, fixed_unless_small(v), ink); }
    MathBox vector(const glm::dvec3& v, Ink ink) const { return value_box(style_, value_of(v), ink); }
    MathBox inverse() const { return with_superscript(style_, letter("M", Ink::Plain), "\u22121", Ink::Plain); }
    MathBox nabla(bool formula, Ink ink) const {
        if (!formula) return letter("n", ink);
        MathBox box = written(style_, look_.fonts.title, "\u2207", ink);
        box.append(letter("f", ink), 0.0f);
        return box;
    }
    MathBox inverse_transpose() const {
        MathBox inside = with_superscript(style_, name_box(style_, Symbol::M3, Meaning::Plain), "\u22121", Ink::Plain);
        return with_superscript(style_, parenthesised(style_, inside, Ink::Plain), "T", Ink::Plain);
    }
    MathBox row(std::initializer_list<MathBox> parts) const {
        MathBox box;
        for (const MathBox& part : parts) box.append(part, box.width > 0.0f ? std::round(0.22f * style_.em) : 0.0f);
        return box;
    }

private:
    const Look& look_;
    MathStyle style_;
};

Told told(const Writing& w, const RaySteps& s, int step) {
    const bool formula = s.f.has_value();
    const Ink grey = Ink::Dim, plain = Ink::Plain, green = Ink::InverseTranspose;
    const MathBox is = w.sign("=");
    switch (step) {
        case 0:
            return {"The ray in the world",
                    {w.row({w.letter("o", plain), is, w.vector(s.world.origin.xyz, plain)}),
                     w.row({w.letter("d", plain), is, w.vector(s.world.direction.xyz, plain)})},
                    "All points o + t d with t > 0. Here d has length 1, so that t is a distance in the world."};
        case 1:
            return {"The same ray in object space",
                    {w.row({w.inverse(), w.letter("o", plain), is, w.vector(s.object->origin.xyz, grey)}),
                     w.row({w.inverse(), w.letter("d", plain), is, w.vector(s.object->direction.xyz, grey)})},
                    "The point goes back with w = 1, the direction with w = 0. The direction is now " +
                        fixed(glm::length(s.object->direction.xyz)) + " long, and stays so: it is not normalised."};
        case 2: {
            std::string words =
                "The first zero of f along the object's ray. Both rays have a bead at each whole t: t is the same in "
                "both spaces.";
            if (!formula)
                words =
                    "The first point that the ray meets. Both rays have a bead at each whole t: t is the same in both "
                    "spaces.";
            if (s.t_if_normalised && std::abs(*s.t_if_normalised - *s.t) > 5e-4)
                words += " Had the direction been normalised, t would come out as " + fixed(*s.t_if_normalised) +
                         ", and o + t d would miss the surface by " + fixed(std::abs(*s.t_if_normalised - *s.t)) + ".";
            return {"The hit", {w.row({w.letter("t", plain), is, w.number(*s.t, plain)})}, words};
        }
        case 3: {
            Told t{"The point in object space",
                   {w.row({w.letter("p", grey), is, w.inverse(), w.letter("o", plain), w.sign("+"),
                           w.letter("t", plain), w.inverse(), w.letter("d", plain), is, w.vector(s.point->xyz, grey)})},
                   formula ? "Here f = " + fixed_unless_small(*s.f) + "." : "On the mesh."};
            return t;
        }
        case 4:
            return {formula ? "The gradient there" : "The normal there",
                    {w.row({w.nabla(formula, grey), is, w.vector(s.gradient->xyz, grey)})},
                    formula ? "The exact partial derivatives: no polygon, no cross product. Its length is " +
                                  fixed(glm::length(s.gradient->xyz)) + "."
                            : "Shapes and meshes have no f: in the gradient's place stands their normal."};
        case 5:
            return {"To the world, by the inverse transpose",
                    {w.row({w.inverse_transpose(), w.nabla(formula, grey), is, w.vector(s.normal->xyz, green)})},
                    "It is " + fixed(glm::length(s.normal->xyz)) + " long: neither 1 nor what it was."};
        case 6:
            return {"Normalise",
                    {w.row({w.letter("n", green), is, w.vector(s.unit->xyz, green)})},
                    "A dot product is a cosine only between vectors of length 1."};
        default:
            return {"Light",
                    {w.row({w.letter("l", plain), is, w.vector(s.toward_light.xyz, plain)}),
                     w.row({w.letter("n", green), w.sign("\u00B7"), w.letter("l", plain), is,
                            w.number(*s.brightness, plain)})},
                    std::string(*s.brightness < 0.0 ? "Below 0: the light is behind the surface. "
                                                    : "This is how bright the point is. ") +
                        "The naive normal M n would have given " + fixed(*s.naive_brightness) + "."};
    }
}

const char* why_no_further(RaySteps::End end) {
    switch (end) {
        case RaySteps::End::Whole: return "";
        case RaySteps::End::NoInverse:
            return "M has no inverse: the ray cannot go to object space. A ray tracer cannot show this object, which M "
                   "has "
                   "flattened.";
        case RaySteps::End::NotAffine:
            return "M is not affine: it does not keep t, so no ray in object space has the same t.";
        case RaySteps::End::Misses: return "The ray meets nothing. Aim it by its knobs in the picture.";
        case RaySteps::End::NoNormal:
            return "\u2207f is zero or does not exist where the ray hits: there is no normal here.";
    }
    return "";
}

// The arrow keys step, and so do not wander from button to button here.
int steps_by_keys() {
    if (ImGui::GetIO().WantTextInput || ImGui::GetIO().KeyMods || ImGui::IsAnyItemActive()) return 0;
    const ImGuiID owner = ImGui::GetID("##stepper");
    for (const ImGuiKey key : {ImGuiKey_LeftArrow, ImGuiKey_RightArrow}) ImGui::SetKeyOwner(key, owner);
    return static_cast<int>(ImGui::IsKeyPressed(ImGuiKey_RightArrow, owner)) -
           static_cast<int>(ImGui::IsKeyPressed(ImGuiKey_LeftArrow, owner));
}

void stepper(const Look& look, AimedRay& ray, int last) {
    int by = steps_by_keys();
    if (!look.still) {
        if (icon_button(look, "##previous",
                        {.icon = Icon::Previous, .about = "Previous step (left arrow).", .enabled = ray.step > 0}))
            by = -1;
        ImGui::SameLine(0, look.px(2));
        if (icon_button(look, "##next",
                        {.icon = Icon::Next, .about = "Next step (right arrow).", .enabled = ray.step < last}))
            by = +1;
        ImGui::SameLine(0, look.px(8));
    }
    if (by != 0) ray.step = std::clamp(std::min(ray.step, last) + by, 0, last);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float height = look.px(30), width = ImGui::GetContentRegionAvail().x,
                each = width / (AimedRay::kLastStep + 1);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int i = 0; i <= AimedRay::kLastStep; ++i) {
        const float x = std::round(from.x + each * static_cast<float>(i)), middle = std::round(from.y + height / 2);
        list.AddRectFilled({x + look.px(1), middle - look.px(2)},
                           {std::round(x + each) - look.px(1), middle + look.px(2)},
                           packed(i <= std::min(ray.step, last) ? look.accent : look.field), look.px(2));
    }
    ImGui::Dummy({width, height});
}

void step_card(const Look& look, const RaySteps& steps, AimedRay& ray, int step) {
    const int current = std::min(ray.step, steps.last_step);
    const Told t = told(Writing(look), steps, step);
    const float gutter = look.px(kGutter), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    ImGui::PushID(step);
    ImGui::SetCursorScreenPos({from.x, from.y + look.px(5)});
    const std::string number = std::to_string(step);
    list.AddText(look.fonts.strong, look.fonts.strong->FontSize, {from.x + look.px(10), from.y + look.px(5)},
                 packed(look.dim), number.c_str());
    ImGui::Indent(gutter);
    ImGui::PushFont(look.fonts.strong);
    ImGui::TextUnformatted(t.title.c_str());
    ImGui::PopFont();
    float x = from.x + gutter, row_height = 0.0f;
    const float gap = look.px(26);
    float y = ImGui::GetCursorScreenPos().y;
    for (const MathBox& box : t.boxes) {
        if (x > from.x + gutter && x + box.width > from.x + width) {
            x = from.x + gutter;
            y += row_height + look.px(4);
        }
        row_height = std::max(row_height, box.height());
        float ascent = 0.0f;
        for (const MathBox& other : t.boxes) ascent = std::max(ascent, other.ascent);
        draw_math(list, look, box, {std::round(x), std::round(y + ascent)});
        x += box.width + gap;
    }
    float descent = 0.0f, ascent = 0.0f;
    for (const MathBox& box : t.boxes) ascent = std::max(ascent, box.ascent), descent = std::max(descent, box.descent);
    ImGui::SetCursorScreenPos({from.x + gutter, y});
    ImGui::Dummy({width - gutter, ascent + descent});
    wrapped(look, look.dim, t.words);
    ImGui::Unindent(gutter);
    const float bottom = ImGui::GetItemRectMax().y + look.px(5);
    list.ChannelsSetCurrent(0);
    if (step == current) {
        list.AddRectFilled(from, {from.x + width, bottom}, packed(faded(look.accent, 0.10f)), look.px(6));
        list.AddRectFilled(from, {from.x + look.px(4), bottom}, packed(look.accent), look.px(2));
    }
    list.ChannelsMerge();
    if (ImGui::IsMouseHoveringRect(from, {from.x + width, bottom}) && ImGui::IsWindowHovered() &&
        ImGui::IsMouseClicked(0))
        ray.step = step;
    ImGui::SetCursorScreenPos({from.x, bottom + look.px(2)});
    ImGui::Dummy({0, 0});
    ImGui::PopID();
}

void aim_bars(const Look& look, AimedRay& ray, const std::array<Point<World>, 2>& now) {
    if (!section(look, "Aim", false)) return;
    static constexpr std::array<const char*, 3> kLetters{"x", "y", "z"};
    const float gap = look.px(6), third = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    const std::array<std::optional<Point<World>>*, 2> points{&ray.from, &ray.toward};
    for (std::size_t k = 0; k < 2; ++k) {
        ImGui::PushID(static_cast<int>(k));
        dim_text(look, k == 0 ? "from" : "toward");
        Point<World> p = points[k]->value_or(now[k]);
        for (glm::length_t i = 0; i < 3; ++i) {
            if (i > 0) ImGui::SameLine(0, gap);
            ImGui::SetNextItemWidth(third);
            if (number_bar(look, kLetters.at(static_cast<std::size_t>(i)), p.xyz[i],
                           {.letter = kLetters.at(static_cast<std::size_t>(i)),
                            .step = 0.05,
                            .about = "In the world. The knobs in the picture can be dragged, too."}))
                *points[k] = p;
        }
        ImGui::PopID();
    }
    if (ImGui::Button("follow the view")) ray.from = ray.toward = std::nullopt;
    tip(look, "From beside the camera, through the middle of the picture.");
    ImGui::SameLine();
}

}  // namespace

void draw_ray_head(Scene& scene, const SideContext& context) {
    const Look& look = context.look;
    ImGui::PushFont(look.fonts.title);
    ImGui::TextUnformatted("A ray, step by step");
    ImGui::PopFont();
    if (scene.ray && context.frame.ray) stepper(look, *scene.ray, context.frame.ray->last_step);
}

void draw_ray_tab(Scene& scene, const SideContext& context) {
    const Look& look = context.look;
    const CameraView& view = context.frame.panes.front().view;
    if (!scene.ray || !context.frame.ray) {
        wrapped(look, look.dim,
                "What a ray tracer does at every pixel: the ray goes to object space, meets the surface there, and the "
                "normal "
                "comes back by the inverse transpose.");
        if (!look.still && ImGui::Button("Send a ray")) {
            const auto [from, toward] = aim(AimedRay{}, scene.camera, view);
            scene.ray = AimedRay{from, toward, 0};
        }
        return;
    }
    const RaySteps& steps = *context.frame.ray;
    const int step = std::min(scene.ray->step, steps.last_step);
    for (int i = 0; i <= step; ++i) step_card(look, steps, *scene.ray, i);
    // The step that is new comes into view.
    ImGuiStorage& shown = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("##shown");
    if (shown.GetInt(id, -1) != step) {
        ImGui::SetScrollHereY(1.0f);
        shown.SetInt(id, step);
    }
    if (steps.end != RaySteps::End::Whole && scene.ray->step >= steps.last_step)
        remark(look, look.bad, why_no_further(steps.end));
    if (look.still) return;
    ImGui::Dummy({0, look.px(4)});
    aim_bars(look, *scene.ray, aim(*scene.ray, scene.camera, view));
    if (ImGui::Button("take the ray away")) scene.ray.reset();
}

}  // namespace normalscope

#include "ui/panel/stack_section.h"

#include "core/base/overload.h"
#include "core/scene/palette.h"
#include "ui/kit/number_bar.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

constexpr std::array<const char*, 3> kLetters{"x", "y", "z"};
constexpr std::array<const char*, 3> kIds{"##x", "##y", "##z"};

ImVec4 axis_color(int i) { return to_imgui(kAxisColors[static_cast<std::size_t>(i)]); }

// Three number bars in one row.
bool row_of_three(const Look& look, glm::dvec3& v, float whole, const NumberBar& like) {
    const float gap = look.px(6), width = std::floor((whole - 2 * gap) / 3);
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        NumberBar bar = like;
        bar.letter = kLetters[k];
        bar.color = axis_color(i);
        changed |= number_bar(look, kIds[k], v[i], bar);
    }
    return changed;
}

void edit(const Look& look, Scale& s, float width, StackMemory& memory) {
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        ImGui::SetNextItemWidth(width);
        double factor = s.factors[i];
        const bool changed = number_bar(look, kIds[k], factor,
                                        {.letter = kLetters[k],
                                         .color = axis_color(i),
                                         .low = -3.0,
                                         .high = 3.0,
                                         .about = "Zero flattens, a negative factor mirrors.",
                                         .rest = 1.0,
                                         .catches = true});
        if (ImGui::IsItemActivated()) memory.factors_at_start = s.factors;
        if (!changed) continue;
        if (memory.lock_scale) {
            const double start = memory.factors_at_start[i];
            for (int j = 0; j < 3; ++j) {
                const double locked = start != 0.0 ? memory.factors_at_start[j] * (factor / start) : factor;
                s.factors[j] = std::clamp(locked, kCoordinate.low, kCoordinate.high);
            }
        }
        s.factors[i] = factor;
    }
}

void edit(const Look& look, Rotate& r, float width, StackMemory&) {
    ImGui::SetNextItemWidth(width);
    number_bar(look, "##degrees", r.degrees,
               {.letter = "angle",
                .low = -180.0,
                .high = 180.0,
                .step = 1.0,
                .decimals = 1,
                .unit = "°",
                .range = kDegrees,
                .about = "Counterclockwise, looking against the axis.",
                .rest = 0.0});
    glm::dvec3 axis = r.axis;
    if (row_of_three(look, axis, width, {.about = "The axis; its length does not matter, but must not be zero."}) &&
        glm::length(axis) > 0.0)
        r.axis = axis;
}

void edit(const Look& look, Translate& t, float width, StackMemory&) {
    row_of_three(look, t.offset, width, {.about = "Moves points, but not normals: vectors have w = 0.", .rest = 0.0});
}

void edit(const Look& look, Shear& s, float width, StackMemory&) {
    struct Part {
        const char *letter, *id, *about;
        double Shear::* value;
    };
    static constexpr std::array<Part, 6> kParts{
        {{"xy", "##xy", "x slides along with y: x' = x + xy·y + xz·z", &Shear::xy},
         {"yx", "##yx", "y slides along with x: y' = y + yx·x + yz·z", &Shear::yx},
         {"zx", "##zx", "z slides along with x: z' = z + zx·x + zy·y", &Shear::zx},
         {"xz", "##xz", "x slides along with z: x' = x + xy·y + xz·z", &Shear::xz},
         {"yz", "##yz", "y slides along with z: y' = y + yx·x + yz·z", &Shear::yz},
         {"zy", "##zy", "z slides along with y: z' = z + zx·x + zy·y", &Shear::zy}}};
    const float gap = look.px(6), third = std::floor((width - 2 * gap) / 3);
    for (std::size_t i = 0; i < kParts.size(); ++i) {
        if (i % 3 != 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(third);
        number_bar(look, kParts[i].id, s.*kParts[i].value,
                   {.letter = kParts[i].letter,
                    .color = axis_color(static_cast<int>(i % 3)),
                    .low = -2.0,
                    .high = 2.0,
                    .about = kParts[i].about,
                    .rest = 0.0,
                    .catches = true});
    }
}

void edit(const Look& look, Matrix& m, float width, StackMemory&) {
    const float gap = look.px(4), quarter = std::floor((width - 3 * gap) / 4);
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            if (c > 0) ImGui::SameLine(0, gap);
            ImGui::PushID(4 * r + c);
            ImGui::SetNextItemWidth(quarter);
            number_bar(look, "##m", m.matrix[c][r],
                       {.about = "Row by row, as it is written: points are columns, M p."});
            ImGui::PopID();
        }
}

std::string list(const glm::dvec3& v) { return brief(v.x) + ", " + brief(v.y) + ", " + brief(v.z); }

}  // namespace

void edit_entry(const Look& look, StackEntry& entry, float width, StackMemory& memory) {
    std::visit([&](auto& e) { edit(look, e, width, memory); }, entry);
}

std::string summary(const StackEntry& entry) {
    return std::visit(
        Overload{
            [](const Scale& s) { return list(s.factors); },
            [](const Rotate& r) { return brief(r.degrees) + "° about (" + list(r.axis) + ")"; },
            [](const Translate& t) { return list(t.offset); },
            [](const Shear& s) {
                std::string text;
                for (const auto& [n, v] :
                     {std::pair{"xy", s.xy}, {"xz", s.xz}, {"yx", s.yx}, {"yz", s.yz}, {"zx", s.zx}, {"zy", s.zy}})
                    if (v != 0.0) text += (text.empty() ? "" : ", ") + std::string(n) + " " + brief(v);
                return text.empty() ? std::string("none") : text;
            },
            [](const Matrix&) { return std::string("4×4"); },
        },
        entry);
}

StackEntry neutral(const StackEntry& entry) {
    return std::visit(Overload{
                          [](const Rotate& r) -> StackEntry { return Rotate{r.axis, 0.0}; },
                          []<class E>(const E&) -> StackEntry { return E{}; },
                      },
                      entry);
}

}  // namespace normalscope

#include "ui/panel/gradient_readout.h"

#include "core/math/value.h"
#include "core/surface/gradient_report.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

std::string off_by(const std::optional<double>& degrees) {
    constexpr double kRounding = 1e-12;  // of unit vectors' components, in degrees
    return degrees ? fixed_unless_small(*degrees < kRounding ? 0.0 : *degrees) + "°" : fixed(std::nullopt);
}

struct Columns {
    float left;
    std::array<float, 4> right;
};
Columns columns(const Look& look) {
    Columns c{ImGui::GetCursorPosX(), {}};
    const float first = look.px(88), width = ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < 4; ++i)
        c.right[i] = c.left + first + (width - first) * static_cast<float>(i + 1) / 4.0f;
    return c;
}

// A unit normal and how far it is off.
void row(const Look& look, const Columns& c, const char* what, const std::optional<glm::dvec3>& v,
         const std::string& off, const char* about) {
    ImGui::BeginGroup();
    ImGui::SetCursorPosX(c.left);
    dim_text(look, what);
    const double length = v ? glm::length(*v) : 0.0;
    for (glm::length_t i = 0; i < 3; ++i) {
        ImGui::SameLine();
        const auto value = length > 0.0 ? std::optional((*v)[i] / length) : std::nullopt;
        text_right(fixed(value), c.right[static_cast<std::size_t>(i)]);
    }
    ImGui::SameLine();
    text_right(off, c.right[3]);
    ImGui::EndGroup();
    tip(look, about);
}

}  // namespace

void gradient_readout(const Look& look, const Frame& frame, std::optional<WrittenFormula>& written) {
    const ImplicitSurface* implicit = frame.surface ? frame.surface->implicit.get() : nullptr;
    if (!implicit || !frame.probe) return;
    const GradientReport report = *gradient_report(*frame.surface, frame.probe->object);
    const auto value = [](double v) { return fixed_unless_small(v); };
    const auto slope = [&](glm::length_t i) { return report.gradient ? value((*report.gradient)[i]) : "–"; };
    const std::array<std::string, 4> values{value(report.f), slope(0), slope(1), slope(2)};
    written_formula(look, written, implicit->source().formula, ImGui::GetContentRegionAvail().x, values.size(), values);
    ImGui::Dummy({0, look.px(2)});

    const Columns c = columns(look);
    dim_text(look, "|∇f|");
    ImGui::SameLine();
    text_right(report.gradient ? fixed(report.length) : "–", c.right[3]);
    ImGui::PushFont(look.fonts.small);
    dim_text(look, "the normal");
    static constexpr std::array<const char*, 4> kWords{"x", "y", "z", "off by"};
    for (std::size_t i = 0; i < kWords.size(); ++i) {
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, look.dim);
        text_right(kWords[i], c.right[i]);
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
    if (report.normal) {
        row(look, c, "∇f / |∇f|", report.normal->xyz, "", "The exact normal, in object space.");
    } else {
        dim_text(look, "∇f / |∇f|");
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, look.bad);
        text_right("no normal here", c.right[2]);
        ImGui::PopStyleColor();
        tip(look, frame.probe->object.borrowed_from
                      ? "∇f is zero, or does not exist: its direction says nothing. What the panel says of n is "
                        "borrowed from a neighbour on the surface."
                      : "∇f is zero, or does not exist: its direction says nothing.");
    }
    const std::string step = "h = " + number_text(report.step);
    const std::string differences =
        "Central differences, (f(x + h) − f(x − h)) / 2h and so on, with " + step + ", scaled to unit length.";
    row(look, c, "differences", report.differences.vector, off_by(report.differences.degrees_off), differences.c_str());
    row(look, c, "polygon", report.polygon ? std::optional(report.polygon->vector) : std::nullopt,
        off_by(report.polygon ? report.polygon->degrees_off : std::nullopt),
        "The cross product of two edges of the triangle there, where the surface is made of triangles.");
    ImGui::PushFont(look.fonts.small);
    dim_text(look, step + "; one polygon of " + grouped(frame.surface->mesh.triangles.size()));
    ImGui::PopFont();
}

}  // namespace normalscope

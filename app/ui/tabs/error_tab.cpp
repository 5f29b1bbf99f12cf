#include "ui/tabs/error_tab.h"

#include "core/base/error.h"
#include "core/scene/palette.h"
#include "ui/kit/number_text.h"
#include "ui/kit/plot.h"
#include "ui/kit/widgets.h"
#include "ui/typeset/small_matrix.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

constexpr float kPlotHeight = 206.0f;
constexpr std::array<double, 7> kQuarterTurn{0, 15, 30, 45, 60, 75, 90};
constexpr std::array<double, 7> kHalfTurn{0, 30, 60, 90, 120, 150, 180};
constexpr std::array<double, 4> kErrors{0, 30, 60, 90};
constexpr std::array<double, 7> kStretches{1, 2, 5, 10, 20, 50, 100};

void measure(ErrorTab& tab, const Scene& scene, const Transform<World, Object>& m, const Frame& frame) {
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const std::optional<NormalMap> map = normal_map(scene, m, Rule::Naive);
    const bool same_matrix = tab.measured_matrix == m.matrix() && tab.measured_rank == matrices.rank;
    if (same_matrix && tab.measured_on == frame.surface && tab.measured_map == map) return;
    if (!same_matrix) tab.family = measured_errors(matrices.naive);
    tab.measured_matrix = m.matrix();
    tab.measured_rank = matrices.rank;
    tab.measured_on = frame.surface;
    tab.measured_map = map;
    tab.histogram = map ? error_histogram(frame.surface->mesh, *map, m) : std::nullopt;
    const NormalMap naive{.matrix = glm::dmat4(matrices.naive)};
    const auto plain = map == naive ? tab.histogram : error_histogram(frame.surface->mesh, naive, m);
    tab.naive_worst = plain ? std::optional(plain->worst_degrees) : std::nullopt;
}

// Where the axis of shares ends: at the highest bar, rounded up, so that it does not change with every small change.
double top_of(const ErrorHistogram& histogram) {
    const double highest = 100.0 * std::ranges::max(histogram.shares);
    for (const double top : {10.0, 20.0, 40.0, 60.0, 100.0})
        if (highest <= top) return top;
    return 100.0;
}

void histogram_plot(const Look& look, const ErrorHistogram& histogram, const std::optional<double>& bound,
                    const std::optional<ErrorStatistics>& exact) {
    const double worst = exact ? exact->worst_degrees : histogram.worst_degrees;
    const double mean = exact ? exact->mean_degrees : histogram.mean_degrees;
    line_key(look, Plot::Line::Dashed, look.text, "mean " + in_degrees(mean, 2), "Averaged over the normals.");
    ImGui::SameLine(0, look.px(18));
    line_key(look, Plot::Line::Solid, look.bad, "worst " + in_degrees(worst, 2), "The largest over the normals.");
    if (bound) {
        ImGui::SameLine(0, look.px(18));
        line_key(look, Plot::Line::Dotted, look.text, "bound " + in_degrees(bound, 2),
                 "atan k − atan 1/k: the largest on any surface.");
    }
    const double top = top_of(histogram);
    const std::array<double, 3> shares{0.0, top / 2, top};
    const Plot plot(look, "histogram",
                    {.high = histogram.most_degrees,
                     .ticks = histogram.most_degrees > 90.0 ? std::span<const double>(kHalfTurn) : kQuarterTurn,
                     .unit = "°",
                     .title = "angle off the true normal"},
                    {.high = top, .ticks = shares, .unit = " %", .title = "share of the surface's normals"},
                    kPlotHeight);
    for (std::size_t i = 0; i < histogram.shares.size(); ++i) {
        if (histogram.shares[i] <= 0.0) continue;
        const double from = histogram.bin_degrees * static_cast<double>(i), to = from + histogram.bin_degrees;
        const ImVec2 low = plot.at(from, 100.0 * histogram.shares[i]), high = plot.at(to, 0.0);
        const ImVec2 top_left{std::round(low.x), std::min(low.y, high.y - 1.0f)},
            bottom_right{std::max(std::round(high.x) - 1.0f, std::round(low.x) + 1.0f), high.y};
        plot.list().AddRectFilled(top_left, bottom_right, packed(to_imgui(error_color((from + to) / 2))));
        plot.list().AddRect(top_left, bottom_right, packed(faded(look.text, 0.45f)));
    }
    if (bound) plot.vertical(*bound, Plot::Line::Dotted, look.text);
    plot.vertical(worst, Plot::Line::Solid, look.bad);
    plot.vertical(mean, Plot::Line::Dashed, look.text);
    if (!plot.hovered()) return;
    const auto bin =
        std::min(static_cast<std::size_t>(plot.x_under_pointer() / histogram.bin_degrees), histogram.shares.size() - 1);
    const double from = histogram.bin_degrees * static_cast<double>(bin);
    ImGui::SetTooltip("%s° to %s°: %s %% of the normals", brief(from).c_str(),
                      brief(from + histogram.bin_degrees).c_str(), fixed(100.0 * histogram.shares[bin], 1).c_str());
}

void curve_plot(const Look& look, const ErrorTab& tab, const std::optional<double>& k) {
    const ImVec4 naive = to_imgui(rule_color(Rule::Naive));
    const Plot plot(
        look, "curve", {.low = 1.0, .high = 100.0, .logarithmic = true, .ticks = kStretches, .title = "k = σmax/σmin"},
        {.high = 90.0, .ticks = kErrors, .unit = "°", .title = "worst angle between M n and (M⁻¹)ᵀ n"}, kPlotHeight);
    ImDrawList& list = plot.list();
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i) {
        const double at = std::pow(100.0, static_cast<double>(i) / kSteps);
        list.PathLineTo(plot.at(at, error_bound_degrees(at)));
    }
    list.PathStroke(packed(look.text), 0, look.px(2));
    for (const MeasuredError& measured : tab.family) {
        const ImVec2 at = plot.at(measured.k, measured.degrees);
        list.AddCircleFilled(at, look.px(4), packed(look.card));
        list.AddCircle(at, look.px(4), packed(naive), 0, look.px(2));
    }
    if (!k) return;
    plot.vertical(*k, Plot::Line::Dashed, faded(look.text, 0.7f));
    if (tab.naive_worst) {
        const ImVec2 at = plot.at(*k, *tab.naive_worst);
        list.AddCircleFilled(at, look.px(7), packed(look.card));
        list.AddCircleFilled(at, look.px(6), packed(naive));
    }
    // In the free corner, below the curve.
    const std::string here = "k = " + fixed(*k, 2) + (*k > 100.0 ? " →" : "");
    const ImFont* font = look.fonts.strong;
    list.AddText(
        font, font->FontSize,
        {std::round(plot.high().x - look.px(10) - font->CalcTextSizeA(font->FontSize, 1e9f, 0, here.c_str()).x),
         plot.high().y - font->FontSize - look.px(8)},
        packed(look.text), here.c_str());
    if (plot.hovered()) {
        const double under = plot.x_under_pointer();
        ImGui::SetTooltip("k = %s: at most %s", fixed(under, 2).c_str(),
                          in_degrees(error_bound_degrees(under), 2).c_str());
    }
}

void curve_key(const Look& look) {
    const ImVec4 naive = to_imgui(rule_color(Rule::Naive));
    line_key(look, Plot::Line::Solid, look.text, "atan k − atan 1/k",
             "The closed form, from Kantorovich's inequality.");
    const auto dot = [&](bool filled, const char* words, const char* about) {
        ImGui::SameLine(0, look.px(14));
        const ImVec2 from = ImGui::GetCursorScreenPos();
        const ImVec2 centre{from.x + look.px(6), from.y + look.fonts.small->FontSize / 2 + look.px(1)};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (filled)
            list.AddCircleFilled(centre, look.px(5), packed(naive));
        else
            list.AddCircle(centre, look.px(4), packed(naive), 0, look.px(2));
        ImGui::PushFont(look.fonts.small);
        ImGui::BeginGroup();
        ImGui::Dummy({look.px(12), 0});
        ImGui::SameLine(0, look.px(5));
        ImGui::TextUnformatted(words);
        ImGui::EndGroup();
        ImGui::PopFont();
        tip(look, about);
    };
    dot(true, "M n on this surface", "The worst over this surface's normals, measured, at M's own k.");
    dot(false, "M's stretch varied",
        "Measured over directions all around, for M with its stretch made smaller and larger along the same axes.");
}

// What the closed form is about, where M is more than M3.
void not_about_this_m(const Look& look, const Frame& frame) {
    std::string numbers;
    if (frame.probe && frame.probe->error_degrees)
        numbers = " At the probe M n is off by " + in_degrees(frame.probe->error_degrees) + ".";
    wrapped(look, look.text,
            "M is not affine: the curve is about its M₃ alone, and says nothing of how far off a rule is. Above, every "
            "normal is held against the image of its own tangent plane." +
                numbers);
}

void never_perpendicular(const Look& look, const Frame& frame, const NormalMatrices& matrices) {
    std::string numbers;
    if (frame.probe && frame.probe->object.has_normal() && matrices.inverse_transpose) {
        const glm::dvec3 n = frame.probe->object.normal.xyz;
        numbers = " = " + fixed(glm::dot(matrices.naive * n, *matrices.inverse_transpose * n)) + " at the probe";
    }
    wrapped(look, look.text,
            "The two are never 90° apart, however large k is, since their dot product is above zero:\n"
            "(M n)·((M⁻¹)ᵀ n) = nᵀ Mᵀ (M⁻¹)ᵀ n = n·n" +
                numbers + ".");
}

}  // namespace

void draw_error_tab(const Scene& scene, ErrorTab& tab, const SideContext& context) {
    const Look& look = context.look;
    Transform<World, Object> m;
    try {
        m = world_from_object(scene);
    } catch (const InputError& error) {
        return remark(look, look.bad, error.what());
    }
    measure(tab, scene, m, context.frame);
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    // The closed form is about M n, and says nothing of other mistakes.
    const bool naive =
        tab.measured_map && tab.measured_map->w == 0.0 && tab.measured_map->matrix == glm::dmat4(matrices.naive);
    const bool open = section(look, "Over the surface");
    const std::string what(text(scene.mistake).formula);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(what.c_str()).x);
    ImGui::TextColored(look.readable(Rule::Naive), "%s", what.c_str());
    if (open) {
        if (tab.histogram)
            histogram_plot(look, *tab.histogram, naive && m.affine() ? matrices.error_bound_degrees() : std::nullopt,
                           context.status.errors);
        else
            remark(look, look.bad,
                   "There is no (M⁻¹)ᵀ n to compare with: M has no inverse. Where M has rank 2, the cofactor still "
                   "gives a "
                   "normal, and M n lies in the flattened surface.");
    }
    if (!section(look, "Against the stretch")) return;
    curve_key(look);
    if (!m.affine()) {
        curve_plot(look, tab, std::nullopt);
        return not_about_this_m(look, context.frame);
    }
    const std::optional<double> k = matrices.condition(), bound = matrices.error_bound_degrees();
    curve_plot(look, tab, k);
    if (bound && tab.naive_worst && *tab.naive_worst < *bound - 1.0)
        wrapped(look, look.dim,
                "This surface stays below the curve: none of its normals lies halfway between the axes of the largest "
                "and the smallest stretch.");
    never_perpendicular(look, context.frame, matrices);
}

}  // namespace normalscope

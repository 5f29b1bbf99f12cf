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

constexpr float kLeastPlotHeight = 150.0f, kMostPlotHeight = 206.0f;
constexpr std::array<double, 7> kQuarterTurn{0, 15, 30, 45, 60, 75, 90};
constexpr std::array<double, 7> kHalfTurn{0, 30, 60, 90, 120, 150, 180};
constexpr std::array<double, 4> kErrors{0, 30, 60, 90};
constexpr std::array<double, 7> kStretches{1, 2, 5, 10, 20, 50, 100};
constexpr std::array<double, 5> kPowers{1, 0.5, 0, -0.5, -1};

void measure(ErrorTab& tab, const Scene& scene, const Transform<World, Object>& m, const Frame& frame) {
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const std::optional<NormalMap> map = normal_map(scene, m, Rule::Naive);
    const bool same_matrix = tab.measured_matrix == m.matrix() && tab.measured_rank == matrices.rank;
    const double power = shown_power(scene);
    if (same_matrix && tab.measured_on == frame.surface && tab.measured_map == map) return;
    if (!same_matrix) tab.powers = measured_between_the_rules(matrices);
    if (!same_matrix || tab.measured_power != power) tab.family = measured_errors(matrices.naive, power);
    tab.measured_power = power;
    tab.measured_matrix = m.matrix();
    tab.measured_rank = matrices.rank;
    tab.measured_on = frame.surface;
    tab.measured_map = map;
    tab.histogram = map ? error_histogram(frame.surface->mesh, *map, m) : std::nullopt;
    const auto bent = between_the_rules(matrices, power);
    const auto plain = scene.mistake == Mistake::Naive ? tab.histogram
                       : bent ? error_histogram(frame.surface->mesh, NormalMap{.matrix = glm::dmat4(*bent)}, m)
                              : std::nullopt;
    tab.naive_worst = plain ? std::optional(plain->worst_degrees) : std::nullopt;
}

// Where the axis of shares ends: at the highest bar, rounded up, so that it does not change with every small change.
double top_of(const ErrorHistogram& histogram) {
    const double highest = 100.0 * std::ranges::max(histogram.shares);
    for (const double top : {10.0, 20.0, 40.0, 60.0, 100.0})
        if (highest <= top) return top;
    return 100.0;
}

// So that three of them have room, where there is that much.
float plot_height(const Look& look) {
    constexpr float kBesidePlots = 84.0f;  // a section's heading and key
    const float room = ImGui::GetIO().DisplaySize.y / look.px(1000) * 1000.0f - kTabsHeight;
    return std::clamp(room / 3.0f - kBesidePlots, kLeastPlotHeight, kMostPlotHeight);
}

void histogram_plot(const Look& look, const ErrorHistogram& histogram, const std::optional<double>& bound,
                    const std::optional<ErrorStatistics>& exact) {
    const double worst = exact ? exact->worst_degrees : histogram.worst_degrees;
    const double mean = exact ? exact->mean_degrees : histogram.mean_degrees;
    line_key(look, Plot::Line::Dashed, look.text, "mean " + in_degrees(mean, 2),
             "Averaged over the object's surface, by area.");
    ImGui::SameLine(0, look.px(18));
    line_key(look, Plot::Line::Solid, look.bad, "worst " + in_degrees(worst, 2),
             "The largest over all the normals of the mesh.");
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
                    {.high = top, .ticks = shares, .unit = " %", .title = "share of the surface"}, plot_height(look));
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
    ImGui::SetTooltip("%s° to %s°: %s %% of the surface", brief(from).c_str(),
                      brief(from + histogram.bin_degrees).c_str(), fixed(100.0 * histogram.shares[bin], 1).c_str());
}

// What the plots' closed form is of: how it is written, and its power.
struct Bent {
    double power = 1.0;
    std::string formula;  ///< "M n"
    std::string title() const { return "worst angle between " + formula + " and (M⁻¹)ᵀ n"; }
};

void measured_dots(const Look& look, const Plot& plot, const std::vector<MeasuredError>& measured,
                   double MeasuredError::* x) {
    for (const MeasuredError& each : measured) {
        const ImVec2 at = plot.at(each.*x, each.degrees);
        plot.list().AddCircleFilled(at, look.px(4), packed(look.card));
        plot.list().AddCircle(at, look.px(4), packed(to_imgui(rule_color(Rule::Naive))), 0, look.px(2));
    }
}

// Where this scene stands: what its surface's worst normal comes to, and the number below the curve's free corner.
void here(const Look& look, const Plot& plot, double x, const std::optional<double>& worst, const std::string& number) {
    plot.vertical(x, Plot::Line::Dashed, faded(look.text, 0.7f));
    ImDrawList& list = plot.list();
    if (worst) {
        const ImVec2 at = plot.at(x, *worst);
        list.AddCircleFilled(at, look.px(7), packed(look.card));
        list.AddCircleFilled(at, look.px(6), packed(to_imgui(rule_color(Rule::Naive))));
    }
    const ImFont* font = look.fonts.strong;
    const float width = font->CalcTextSizeA(font->FontSize, 1e9f, 0, number.c_str()).x;
    list.AddText(font, font->FontSize,
                 {std::round(plot.high().x - look.px(10) - width), plot.high().y - font->FontSize - look.px(8)},
                 packed(look.text), number.c_str());
}

void curve_plot(const Look& look, const ErrorTab& tab, const std::optional<double>& k, const Bent& bent) {
    const std::string title = bent.title();
    const Plot plot(look, "curve",
                    {.low = 1.0, .high = 100.0, .logarithmic = true, .ticks = kStretches, .title = "k = σmax/σmin"},
                    {.high = 90.0, .ticks = kErrors, .unit = "°", .title = title.c_str()}, plot_height(look));
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i) {
        const double at = std::pow(100.0, static_cast<double>(i) / kSteps);
        plot.list().PathLineTo(plot.at(at, error_bound_degrees(at, bent.power)));
    }
    plot.list().PathStroke(packed(look.text), 0, look.px(2));
    measured_dots(look, plot, tab.family, &MeasuredError::k);
    if (!k) return;
    here(look, plot, *k, tab.naive_worst, "k = " + fixed(*k, 2) + (*k > 100.0 ? " →" : ""));
    if (plot.hovered()) {
        const double under = plot.x_under_pointer();
        ImGui::SetTooltip("k = %s: at most %s", fixed(under, 2).c_str(),
                          in_degrees(error_bound_degrees(under, bent.power), 2).c_str());
    }
}

void powers_plot(const Look& look, const ErrorTab& tab, double k, double power) {
    const Plot plot(look, "powers", {.low = 1.0, .high = -1.0, .ticks = kPowers, .title = "p: from M n to (M⁻¹)ᵀ n"},
                    {.high = 90.0, .ticks = kErrors, .unit = "°", .title = "worst angle between R Sᵖ n and (M⁻¹)ᵀ n"},
                    plot_height(look));
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i) {
        const double at = 1.0 - 2.0 * i / kSteps;
        plot.list().PathLineTo(plot.at(at, error_bound_degrees(k, at)));
    }
    plot.list().PathStroke(packed(look.text), 0, look.px(2));
    measured_dots(look, plot, tab.powers, &MeasuredError::power);
    // In the free corner, which is above the curve's end.
    here(look, plot, power, tab.naive_worst, "");
    const std::string number = "p = " + fixed(power, 2);
    const ImFont* font = look.fonts.strong;
    plot.list().AddText(
        font, font->FontSize,
        {std::round(plot.high().x - look.px(10) - font->CalcTextSizeA(font->FontSize, 1e9f, 0, number.c_str()).x),
         plot.low().y + look.px(6)},
        packed(look.text), number.c_str());
    if (plot.hovered()) {
        const double under = plot.x_under_pointer();
        ImGui::SetTooltip("p = %s: at most %s", fixed(under, 2).c_str(),
                          in_degrees(error_bound_degrees(k, under), 2).c_str());
    }
}

void curve_key(const Look& look, const char* closed_form, const Bent& bent, const char* varied, const char* how) {
    const ImVec4 naive = to_imgui(rule_color(Rule::Naive));
    line_key(look, Plot::Line::Solid, look.text, closed_form, "The closed form, from Kantorovich's inequality.");
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
    dot(true, (bent.formula + " here").c_str(), "The worst over this surface's normals, measured.");
    dot(false, varied, how);
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

// Where nothing but the naive rule is in its place.
void between_the_rules_section(const Look& look, const ErrorTab& tab, const NormalMatrices& matrices,
                               const Bent& bent) {
    if (!section(look, "Between the two rules")) return;
    const std::optional<double> k = matrices.condition();
    if (!k)
        return remark(look, look.bad,
                      "M has no inverse. From M n the arrows can be bent as far as the rotation alone, and there is no "
                      "(M⁻¹)ᵀ n to compare them with.");
    curve_key(look, "atan k^q − atan k^−q, q = (p + 1)/2", bent, "p varied",
              "Measured over directions all around, for this M.");
    powers_plot(look, tab, *k, bent.power);
}

void against_the_stretch_section(const ErrorTab& tab, const Transform<World, Object>& m, const Bent& bent,
                                 const SideContext& context) {
    const Look& look = context.look;
    if (!section(look, "Against the stretch")) return;
    curve_key(look, bent.power == 1.0 ? "atan k − atan 1/k" : "atan k^q − atan k^−q", bent, "M's stretch varied",
              "Measured over directions all around, for M with its stretch made smaller and larger along the same "
              "axes.");
    if (!m.affine()) {
        curve_plot(look, tab, std::nullopt, bent);
        return not_about_this_m(look, context.frame);
    }
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const std::optional<double> bound = matrices.error_bound_degrees(bent.power);
    curve_plot(look, tab, matrices.condition(), bent);
    if (bound && tab.naive_worst && *tab.naive_worst < *bound - 1.0)
        wrapped(look, look.dim,
                "This surface stays below the curve: it has no normal in the direction that M treats worst.");
    never_perpendicular(look, context.frame, matrices);
}

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
    // The closed form says nothing of other mistakes.
    const bool naive = scene.mistake == Mistake::Naive;
    const Bent bent{shown_power(scene), naive ? in_naive_place(scene).formula : std::string(formula(Rule::Naive))};
    const bool open = section(look, "Over the surface");
    const std::string what = in_naive_place(scene).formula;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(what.c_str()).x);
    ImGui::TextColored(look.readable(Rule::Naive), "%s", what.c_str());
    if (open) {
        if (tab.histogram)
            histogram_plot(look, *tab.histogram,
                           naive && m.affine() ? matrices.error_bound_degrees(bent.power) : std::nullopt,
                           context.status.errors);
        else
            remark(
                look, look.bad,
                m.affine() && matrices.rank == 3
                    ? "There is no surface here, and so no normal."
                    : "There is no (M⁻¹)ᵀ n to compare with: M has no inverse. Where M has rank 2, the cofactor still "
                      "gives a normal, and M n lies in the flattened surface.");
    }
    if (naive && m.affine()) between_the_rules_section(look, tab, matrices, bent);
    against_the_stretch_section(tab, m, bent, context);
}

}  // namespace normalscope

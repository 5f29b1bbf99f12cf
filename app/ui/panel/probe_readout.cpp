#include "ui/panel/panel.h"

#include "core/base/error.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/panel/gradient_readout.h"
#include "ui/panel/panel_memory.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace normalscope {

namespace {

constexpr double kPerpendicular = 1e-9;  ///< |n·t| against |n||t|

// Where the columns end, in window coordinates.
struct Columns {
    float left = 0.0f;
    std::array<float, 4> right{};
    float top = 0.0f;
};

Columns columns(float first, std::size_t count) {
    Columns c{.left = ImGui::GetCursorPosX()};
    const float width = ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < count; ++i)
        c.right[i] = c.left + first + (width - first) * static_cast<float>(i + 1) / static_cast<float>(count);
    return c;
}

void heading(const Look& look, const Columns& c, std::string_view first, std::span<const std::string_view> words) {
    ImGui::PushFont(look.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, look.dim);
    ImGui::SetCursorPosX(c.left);
    ImGui::TextUnformatted(first.data(), first.data() + first.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        ImGui::SameLine();
        text_right(words[i], c.right[i]);
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

// One line: a name, three coordinates, and for normals the length.
void coordinates(const Look& look, const Columns& c, const char* what, const ImVec4& color,
                 const std::optional<glm::dvec3>& v, bool length, const char* about) {
    ImGui::BeginGroup();
    ImGui::SetCursorPosX(c.left);
    ImGui::TextColored(color, "%s", what);
    for (int i = 0; i < 3; ++i) {
        ImGui::SameLine();
        text_right(v ? fixed((*v)[i]) : fixed(std::nullopt), c.right[static_cast<std::size_t>(i)]);
    }
    if (length) {
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, look.dim);
        text_right(v ? fixed(glm::length(*v)) : fixed(std::nullopt), c.right[3]);
        ImGui::PopStyleColor();
    }
    ImGui::EndGroup();
    tip(look, about);
}

void where_and_whither(const Look& look, const ProbeInWorld& probe, const Scene& scene, std::size_t rules) {
    const Columns c = columns(look.px(88), 4);
    static constexpr std::array<std::string_view, 4> kWords{"x", "y", "z", "length"};
    heading(look, c, "", kWords);
    const ImVec4 grey = look.dim;
    coordinates(look, c, "p object", grey, probe.object.point.xyz, false, "The probe on the untransformed object.");
    coordinates(look, c, "p world", look.text, probe.point.xyz, false,
                "M p: a point is sent through all of M, translation included.");
    coordinates(look, c, "n object", grey,
                probe.object.has_normal() ? std::optional(probe.object.normal.xyz) : std::nullopt, true,
                "The object's normal there, of unit length.");
    static constexpr std::array<const char*, 3> kAbout{
        "M n, as it comes, before it is normalised. Not a normal unless M is rigid, or nearly.",
        "(M⁻¹)ᵀ n, as it comes, before it is normalised. A dot product for shading needs it at length 1.",
        "cof(M) n = det(M) (M⁻¹)ᵀ n, as it comes. Its length is the factor by which M changes the surface's area "
        "here."};
    for (std::size_t i = 0; i < rules; ++i) {
        const std::string what = normal_formula(kRules[i], scene);
        std::optional<glm::dvec3> n;
        if (probe.normals[i]) n = probe.normals[i]->xyz;
        coordinates(look, c, what.c_str(), look.readable(kRules[i]), n, true, kAbout[i]);
    }
}

// A dot product with its verdict, which does not rest on colour alone.
void dot_cell(const Look& look, double dot, double lengths, float right) {
    const bool zero = std::abs(dot) <= kPerpendicular * lengths;
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, zero ? look.good : look.bad);
    text_right(zero ? "✓" : "✗", right);
    ImGui::SameLine();
    text_right(fixed_unless_small(zero ? 0.0 : dot), right - look.px(19));
    ImGui::PopStyleColor();
}

void dots(const Look& look, const ProbeInWorld& probe, const Scene& scene, std::size_t rules) {
    const Columns c = columns(look.px(88), 3);
    static constexpr std::array<std::string_view, 3> kWords{"n · t₁", "n · t₂", "off by"};
    heading(look, c, "still ⊥ ?", kWords);
    tip(look,
        "t₁ and t₂ are tangents of the surface, carried along by M. A normal is what stays perpendicular to both: n · "
        "t = 0.");
    if (!probe.affine) ImGui::TextColored(look.bad, "M is not affine: no 3×3 rule is right");
    if (about_tangents(scene.mistake) && scene.rule == Rule::Naive)
        ImGui::TextColored(look.bad, "the tangents are wrong here, not n");
    for (std::size_t i = 0; i < rules; ++i) {
        ImGui::BeginGroup();
        ImGui::SetCursorPosX(c.left);
        ImGui::TextColored(look.readable(kRules[i]), "%s", normal_formula(kRules[i], scene).c_str());
        const auto& n = probe.normals[i];
        const bool any = n && probe.dots[i] && glm::length(n->xyz) > 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            if (any) {
                dot_cell(look, (*probe.dots[i])[k], glm::length(n->xyz) * glm::length(probe.tangents[k].xyz),
                         c.right[k]);
            } else {
                ImGui::SameLine();
                text_right(fixed(std::nullopt), c.right[k] - look.px(19));
            }
        }
        ImGui::SameLine();
        const auto off = any && probe.truth ? angle_degrees(n->xyz, probe.truth->xyz) : std::nullopt;
        text_right(in_degrees(off), c.right[2]);
        ImGui::EndGroup();
        tip(look, kRules[i] == Rule::Cofactor
                      ? "180° under a reflection: the cofactor follows the winding, which the mirror reverses, while "
                        "the inverse transpose keeps pointing outward. Each is right for its own question."
                      : "The two dot products with the tangents, and the angle to the normal of "
                        "the image: (M⁻¹)ᵀ n, where M is affine.");
    }
}

// A row for each pinned point: its number, the verdicts of the two rules, the angle between them, and a way to let it go.
void pinned_rows(const Look& look, const Frame& frame, Scene& scene) {
    if (frame.pinned.empty()) return;
    const Columns c = columns(look.px(30), 3);
    const std::string naive = normal_formula(Rule::Naive, scene);
    const std::array<std::string_view, 3> words{naive, "(M⁻¹)ᵀ n", "off by"};
    ImGui::Dummy({0, look.px(4)});
    heading(look, c, "pinned", words);
    std::optional<std::size_t> let_go;
    for (std::size_t i = 0; i < frame.pinned.size(); ++i) {
        const std::optional<ProbeInWorld>& probe = frame.pinned[i];
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetCursorPosX(c.left);
        if (ImGui::SmallButton(std::to_string(i + 1).c_str())) let_go = i;
        tip(look, "Let this point go.");
        std::size_t column = 0;
        for (const Rule rule : {Rule::Naive, Rule::InverseTranspose}) {
            const std::optional<Normal<World>> n = probe ? probe->normals[rule] : std::nullopt;
            const bool right = n && probe->truth && angle_degrees(n->xyz, probe->truth->xyz).value_or(90.0) < 1e-6;
            ImGui::SameLine();
            ImGui::PushStyleColor(ImGuiCol_Text, !n ? look.dim : right ? look.good : look.bad);
            text_right(!n ? "—" : right ? "✓" : "✗", c.right[column++]);
            ImGui::PopStyleColor();
        }
        ImGui::SameLine();
        text_right(in_degrees(probe ? probe->error_degrees : std::nullopt), c.right[2]);
        ImGui::PopID();
    }
    ImGui::Dummy({0, look.px(4)});
    if (let_go && *let_go < scene.pinned.size())
        scene.pinned.erase(scene.pinned.begin() + static_cast<std::ptrdiff_t>(*let_go));
}

// Three figures in a row: what they are above, what they come to below.
void over_the_surface(const Look& look, const Scene& scene, const std::optional<ErrorStatistics>& errors) {
    std::optional<double> bound;
    try {
        const Transform<World, Object> m = world_from_object(scene);
        // It says nothing of other mistakes.
        if (m.affine() && scene.mistake == Mistake::Naive)
            bound = m.normal_matrices_by_rule().error_bound_degrees(shown_power(scene));
    } catch (const InputError&) {  // said elsewhere
    }
    const auto worst = errors ? std::optional(errors->worst_degrees) : std::nullopt;
    const auto mean = errors ? std::optional(errors->mean_degrees) : std::nullopt;
    struct Figure {
        const char* label;
        std::optional<double> value;
        const char* about;
    };
    const std::array<Figure, 3> figures{
        {{"worst", worst, "The largest error over the normals of the surface as drawn."},
         {"mean", mean, "The error, averaged over the normals of the surface as drawn."},
         {"bound", bound,
          "atan k − atan 1/k with k = σ₁/σ₃: the largest error that this M can cause on any surface "
          "(Kantorovich's inequality)."}}};
    const std::string whose =
        plainly_naive(scene) ? "naive rule’s error" : "error of “" + in_naive_place(scene).title + "”";
    dim_text(look, (whose + ", over the whole surface").c_str());
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float gap = look.px(6), width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3),
                height = look.px(46);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const ImVec2 low{from.x + (width + gap) * static_cast<float>(i), from.y}, high{low.x + width, low.y + height};
        ImGui::SetCursorScreenPos(low);
        ImGui::Dummy({width, height});
        tip(look, figures[i].about);
        list.AddRectFilled(low, high, packed(look.card), look.px(6));
        list.AddText({low.x + look.px(8), low.y + look.px(4)}, packed(look.dim), figures[i].label);
        const std::string text = in_degrees(figures[i].value);
        const ImFont* font = look.fonts.body;
        const float text_width = font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str()).x;
        list.AddText(font, font->FontSize,
                     {std::round(high.x - text_width - look.px(8)), high.y - font->FontSize - look.px(3)},
                     packed(look.text), text.c_str());
    }
    ImGui::SetCursorScreenPos({from.x, from.y + height});
    ImGui::Dummy({0, 0});
}

// At the right of the section's title: what is said of the probe's place, and what can be done about it.
void beside_title(const Look& look, Scene& scene, const Frame& frame) {
    const char* const where = scene.probe ? "let go" : "follows the view";
    ImGui::PushFont(look.fonts.small);
    const float pad = 2 * ImGui::GetStyle().FramePadding.x, right = ImGui::GetContentRegionMax().x;
    const float width = ImGui::CalcTextSize(where).x + (scene.probe ? pad : 0.0f);
    if (frame.probe && scene.pinned.size() < Scene::kMostPinned) {
        ImGui::SameLine(right - width - ImGui::CalcTextSize("pin").x - pad - look.px(8));
        if (ImGui::SmallButton("pin")) scene.pinned.push_back(frame.probe->object.point);
        tip(look, "Keep this point as a row below (P). Drag the probe on, and compare up to four of them.");
    }
    ImGui::SameLine(right - width);
    if (scene.probe) {
        if (ImGui::SmallButton(where)) scene.probe.reset();
        tip(look, "Let the probe follow the view again: the surface's point nearest the middle of the picture.");
    } else {
        dim_text(look, where);
        tip(look, "The surface's point nearest the middle of the picture. Click the surface to put the probe there.");
    }
    ImGui::PopFont();
}

}  // namespace

void probe_section(Scene& scene, PanelMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    const bool open = section(look, "Probe");
    beside_title(look, scene, context.frame);
    if (!open) return;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(8), 0));
    if (const auto& probe = context.frame.probe) {
        if (context.frame.surface && context.frame.surface->implicit) {
            gradient_readout(look, context.frame, memory.at_probe);
            ImGui::Dummy({0, look.px(4)});
        }
        const std::size_t rules = kRules.size() - (cofactor_in_sight(scene, context) ? 0 : 1);
        where_and_whither(look, *probe, scene, rules);
        ImGui::Dummy({0, look.px(4)});
        dots(look, *probe, scene, rules);
        pinned_rows(look, context.frame, scene);
    } else {
        dim_text(look, "This surface has no point to look at.");
    }
    ImGui::Dummy({0, look.px(3)});
    ImGui::PushFont(look.fonts.small);
    over_the_surface(look, scene, context.status.errors);
    ImGui::PopFont();
    ImGui::PopStyleVar();
}

}  // namespace normalscope

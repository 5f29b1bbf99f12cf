#include "ui/probe_trail.h"

#include "core/scene/palette.h"
#include "ui/kit/number_text.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

constexpr std::size_t kMost = 4000;
constexpr double kLeap = 0.4;  // of the object: what is further was no drag

// But for the camera, the points that are kept beside it, and what only changes how things look.
bool same_but_for_probe(Scene a, const Scene& b) {
    a.probe = b.probe;
    a.pinned = b.pinned;
    a.camera = b.camera;
    a.theme = b.theme;
    return a == b;
}

}  // namespace

void ProbeTrail::follow(const Scene& scene, const Frame& frame) {
    const bool same = scene_ && same_but_for_probe(*scene_, scene);
    const bool moved = !scene_ || scene_->probe != scene.probe;
    if (!same) steps_.clear();
    if (same && !moved) return;
    scene_ = scene;
    if (!scene.probe || !frame.probe || !frame.probe->error_degrees) {
        steps_.clear();
        at_.reset();
        return;
    }
    const Point<Object> here = frame.probe->object.point;
    const double step = at_ ? glm::distance(at_->xyz, here.xyz) : 0.0;
    if (step > kLeap * glm::length(frame.surface->extent) || steps_.size() >= kMost) steps_.clear();
    steps_.push_back({steps_.empty() ? 0.0 : steps_.back().way + step, *frame.probe->error_degrees});
    at_ = here;
}

void ProbeTrail::draw(const Look& look, const Frame& frame) const {
    if (steps_.size() < 3 || !(steps_.back().way > 0.0)) return;
    const ThemeColors colors = theme_colors(frame.theme);
    // In a narrow picture it leaves the middle to the object.
    const float whole = look.px(232), width = std::min(whole, 0.42f * static_cast<float>(frame.rect.size.x));
    if (width < look.px(140)) return;
    const float margin = look.px(14), height = look.px(104), pad = look.px(10);
    const ImVec2 high{static_cast<float>(frame.rect.origin.x + frame.rect.size.x) - margin,
                      static_cast<float>(frame.rect.origin.y) + margin + height},
        low{high.x - width, high.y - height};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto ink = [&](const glm::vec3& color, float alpha = 1.0f) { return packed(faded(to_imgui(color), alpha)); };
    const auto write = [&](const ImFont* font, ImVec2 at, ImU32 color, const std::string& text) {
        list.AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, color, text.c_str());
    };
    list.AddRectFilled(low, high, ink(colors.text_shadow, 0.78f), look.px(8));
    list.AddRect(low, high, ink(colors.grid, 0.25f), look.px(8));
    const ImFont* font = look.fonts.small;
    write(font, {low.x + pad, low.y + look.px(5)}, ink(colors.text),
          width < whole ? "angle off" : "angle off, along the way");
    const std::string now = in_degrees(steps_.back().degrees);
    write(look.fonts.strong,
          {high.x - pad - look.fonts.strong->CalcTextSizeA(look.fonts.strong->FontSize, 1e9f, 0, now.c_str()).x,
           low.y + look.px(4)},
          packed(look.readable(Rule::Naive)), now);

    double most = 0.0;
    for (const Step& step : steps_) most = std::max(most, step.degrees);
    double top = 180.0;
    for (const double each : {90.0, 60.0, 30.0, 10.0})
        if (most <= each) top = each;
    const ImVec2 from{low.x + pad + look.px(24), low.y + look.px(30)}, to{high.x - pad, high.y - pad};
    const auto y = [&](double degrees) { return to.y - static_cast<float>(degrees / top) * (to.y - from.y); };
    for (const double tick : {0.0, top}) {
        list.AddLine({from.x, y(tick)}, {to.x, y(tick)}, ink(colors.grid, 0.6f));
        const std::string text = std::to_string(std::lround(tick)) + "°";
        write(font,
              {from.x - look.px(5) - font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str()).x,
               y(tick) - font->FontSize / 2},
              ink(colors.text), text);
    }
    const double way = steps_.back().way;
    std::vector<ImVec2> line;
    for (const Step& step : steps_)
        line.push_back({from.x + static_cast<float>(step.way / way) * (to.x - from.x), y(step.degrees)});
    list.AddPolyline(line.data(), static_cast<int>(line.size()), packed(look.readable(Rule::Naive)), 0, look.px(2));
    list.AddCircleFilled(line.back(), look.px(4), packed(look.readable(Rule::Naive)));
}

}  // namespace normalscope

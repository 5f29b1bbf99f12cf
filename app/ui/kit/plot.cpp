#include "ui/kit/plot.h"

#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

// Where a value stands between the axis' ends, 0 … 1.
double share(const PlotAxis& axis, double value) {
    const auto to = [&](double v) { return axis.logarithmic ? std::log(std::max(v, 1e-300)) : v; };
    return (to(value) - to(axis.low)) / (to(axis.high) - to(axis.low));
}

void stroke(const Look& look, ImDrawList& list, ImVec2 from, ImVec2 to, Plot::Line line, const ImVec4& ink) {
    const float weight = look.px(2), length = std::hypot(to.x - from.x, to.y - from.y);
    if (line == Plot::Line::Solid || length <= 0.0f) return list.AddLine(from, to, packed(ink), weight);
    const float on = line == Plot::Line::Dashed ? look.px(7) : look.px(2),
                off = look.px(line == Plot::Line::Dashed ? 4 : 3);
    const int dashes = static_cast<int>(std::ceil(length / (on + off)));
    for (int i = 0; i < dashes; ++i) {
        const float begin = static_cast<float>(i) * (on + off), end = std::min(begin + on, length);
        const float a = begin / length, b = end / length;
        list.AddLine({from.x + a * (to.x - from.x), from.y + a * (to.y - from.y)},
                     {from.x + b * (to.x - from.x), from.y + b * (to.y - from.y)}, packed(ink), weight);
    }
}

}  // namespace

Plot::Plot(const Look& look, const char* id, const PlotAxis& x, const PlotAxis& y, float height)
    : look_{look}, x_{x}, y_{y}, list_{*ImGui::GetWindowDrawList()} {
    const ImFont* font = look.fonts.small;
    const auto extent = [&](const char* text) { return font->CalcTextSizeA(font->FontSize, 1e9f, 0, text).x; };
    const auto write = [&](float at_x, float at_y, const ImVec4& ink, const char* text) {
        list_.AddText(font, font->FontSize, {std::round(at_x), std::round(at_y)}, packed(ink), text);
    };
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, text = font->FontSize;
    low_ = {from.x + look.px(44), from.y + text + look.px(6)};
    high_ = {from.x + width - look.px(14), from.y + look.px(height) - 2 * text - look.px(6)};

    list_.AddRectFilled(low_, high_, packed(look.card));
    write(from.x, from.y, look.dim, y.title);
    for (const double tick : y.ticks) {
        const float line = std::round(this->y(tick));
        const std::string label = brief(tick) + y.unit;
        list_.AddLine({low_.x, line}, {high_.x, line}, packed(look.line));
        write(low_.x - look.px(6) - extent(label.c_str()), line - text / 2, look.text, label.c_str());
    }
    for (const double tick : x.ticks) {
        const float line = std::round(this->x(tick));
        const std::string label = brief(tick) + x.unit;
        list_.AddLine({line, low_.y}, {line, high_.y + look.px(3)}, packed(look.line));
        write(line - extent(label.c_str()) / 2, high_.y + look.px(4), look.text, label.c_str());
    }
    list_.AddLine({low_.x, high_.y}, high_, packed(look.dim));
    list_.AddLine(low_, {low_.x, high_.y}, packed(look.dim));
    write(high_.x - extent(x.title), high_.y + look.px(5) + text, look.dim, x.title);

    ImGui::PushID(id);
    ImGui::Dummy({width, look.px(height)});
    ImGui::PopID();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    hovered_ = ImGui::IsItemHovered() && pointer.x >= low_.x && pointer.x < high_.x && pointer.y >= low_.y &&
               pointer.y < high_.y;
}

float Plot::x(double value) const {
    return low_.x + static_cast<float>(std::clamp(share(x_, value), 0.0, 1.0)) * (high_.x - low_.x);
}
float Plot::y(double value) const {
    return high_.y - static_cast<float>(std::clamp(share(y_, value), 0.0, 1.0)) * (high_.y - low_.y);
}

double Plot::x_under_pointer() const {
    const double t = (ImGui::GetIO().MousePos.x - low_.x) / (high_.x - low_.x);
    return x_.logarithmic ? x_.low * std::pow(x_.high / x_.low, t) : x_.low + t * (x_.high - x_.low);
}

void Plot::vertical(double value, Line line, const ImVec4& ink) const {
    const float at = std::round(x(value));
    stroke(look_, list_, {at, high_.y}, {at, low_.y}, line, ink);
}

void line_key(const Look& look, Plot::Line line, const ImVec4& ink, const std::string& words, const char* about) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float middle = from.y + look.fonts.small->FontSize / 2;
    stroke(look, *ImGui::GetWindowDrawList(), {from.x, middle}, {from.x + look.px(22), middle}, line, ink);
    ImGui::PushFont(look.fonts.small);
    ImGui::BeginGroup();
    ImGui::Dummy({look.px(22), 0});
    ImGui::SameLine(0, look.px(6));
    ImGui::TextUnformatted(words.c_str());
    ImGui::EndGroup();
    ImGui::PopFont();
    tip(look, about);
}

}  // namespace normalscope

#pragma once

#include "ui/kit/style.h"

#include <span>
#include <string>

namespace normalscope {

/// One direction of a plot: what it runs over and what is written at it.
struct PlotAxis {
    double low = 0.0, high = 1.0;
    bool logarithmic = false;
    std::span<const double> ticks{};
    const char* unit = "";   ///< behind each tick's number
    const char* title = "";  ///< x: below, at the right; y: above, at the left
};

/// A plot as wide as the column: axes, grid lines and numbers; what is plotted is drawn by whoever made it.
class Plot {
public:
    /// Takes its room in the column. `height` in logical pixels, all included.
    Plot(const Look& look, const char* id, const PlotAxis& x, const PlotAxis& y, float height);

    float x(double value) const;
    float y(double value) const;
    ImVec2 at(double x_value, double y_value) const { return {x(x_value), y(y_value)}; }
    ImVec2 low() const { return low_; }
    ImVec2 high() const { return high_; }
    ImDrawList& list() const { return list_; }
    bool hovered() const { return hovered_; }
    /// The value under the pointer.
    double x_under_pointer() const;

    enum class Line { Solid, Dashed, Dotted };
    void vertical(double value, Line line, const ImVec4& ink) const;

private:
    const Look& look_;
    PlotAxis x_, y_;
    ImVec2 low_, high_;  ///< of the plotting area, in screen coordinates
    ImDrawList& list_;
    bool hovered_ = false;
};

/// What a kind of line means: a sample of it, and words.
void line_key(const Look& look, Plot::Line line, const ImVec4& ink, const std::string& words, const char* about);

}  // namespace normalscope

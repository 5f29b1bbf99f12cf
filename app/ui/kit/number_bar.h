#pragma once

#include "core/scene/scene_fields.h"
#include "ui/kit/style.h"

#include <imgui.h>

#include <optional>

namespace normalscope {

/// A number to be dragged: the bar's tip follows the pointer, so that a click alone changes nothing; a double click or
/// Ctrl+click types. Between `low` and `high` by mouse; whatever `range` allows when typed.
struct NumberBar {
    const char* letter = "";        ///< at the left
    std::optional<ImVec4> color{};  ///< of the letter and the bar
    double low = 0.0, high = 0.0;   ///< equal: no bar, and no limit but `range`
    double zero = 0.0;              ///< where the bar starts
    double step = 0.01;             ///< to which dragging rounds
    int decimals = 3;
    const char* unit = "";
    Range range = kCoordinate;
    const char* about = "";  ///< for its tooltip
    std::optional<double>
        rest{};            ///< to which a click on its letter sets it back; empty: that is a click like any other
    bool catches = false;  ///< while it is dragged, at numbers that one means (core/base/caught.h)
};
/// As wide as ImGui::SetNextItemWidth says. True where the value has changed; it is always finite and within the range.
bool number_bar(const Look& look, const char* id, double& value, const NumberBar& bar);
bool number_bar(const Look& look, const char* id, int& value, const NumberBar& bar);

struct DirectionBar {
    const char *letter, *about;
    std::optional<double> rest{};  ///< as NumberBar's
};
/// A direction's azimuth and elevation in degrees, as bars beside each other over the width that there is.
void direction_bars(const Look& look, const char* id, double& azimuth, double& elevation,
                    const DirectionBar& azimuth_bar, const DirectionBar& elevation_bar);

}  // namespace normalscope

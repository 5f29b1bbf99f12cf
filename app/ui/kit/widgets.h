#pragma once

#include "core/frame/frame.h"
#include "core/scene/scene_fields.h"
#include "ui/kit/icons.h"
#include "ui/kit/style.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// Explains the last item while the pointer rests on it.
void tip(const Look& look, const char* text);

/// Begins a window that stays where it is, beside the picture. The renderer has filled what lies beside the picture with
/// the panel's colour, so that only one that covers the picture, or another one (`over_another`), needs a ground of its own.
void begin_beside(const PixelRect& picture, const char* id, ImVec2 at, ImVec2 size, ImGuiWindowFlags flags = 0,
                  bool over_another = false);

/// A heading that opens and closes what follows; what is put on the same line stands at its right.
bool section(const Look& look, const char* title, bool open_at_first = true);

/// As ImGui::BeginCombo.
bool begin_combo(const Look& look, const char* id, const std::string& current, float width);

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
};
/// As wide as ImGui::SetNextItemWidth says. True where the value has changed; it is always finite and within the range.
bool number_bar(const Look& look, const char* id, double& value, const NumberBar& bar);
bool number_bar(const Look& look, const char* id, int& value, const NumberBar& bar);

struct DirectionBar {
    const char *letter, *about;
};
/// A direction's azimuth and elevation in degrees, as bars beside each other over the width that there is.
void direction_bars(const Look& look, const char* id, double& azimuth, double& elevation,
                    const DirectionBar& azimuth_bar, const DirectionBar& elevation_bar);

struct IconButton {
    Icon icon;
    const char* about;  ///< for its tooltip
    bool enabled = true;
    float side = 30.0f;  ///< logical pixels
};
bool icon_button(const Look& look, const char* id, const IconButton& button);

struct Segment {
    const char* label;
    const char* about;
};
/// Buttons in one row of which one is down. True where another was chosen.
bool segmented(const Look& look, const char* id, int& chosen, std::span<const Segment> choices);

/// Text that ends where the column does, or at `right` (window coordinates).
void text_right(std::string_view text, float right);
void dim_text(const Look& look, std::string_view text);
/// The text, or its beginning and "…" where it is wider than `width`.
std::string shortened(std::string text, float width);

/// A matrix in brackets, its columns aligned to the right; the upper left 3×3, which alone moves normals, stands out.
void matrix_in_brackets(const Look& look, const glm::dmat4& m, float width);

}  // namespace normalscope

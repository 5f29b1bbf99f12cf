#pragma once

#include "core/frame/frame.h"
#include "ui/kit/icons.h"
#include "ui/kit/style.h"

#include <glm/mat4x4.hpp>

#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// Explains the last item while the pointer rests on it.
void tip(const Look& look, const char* text);
/// Beside the pointer, or where ImGui::SetNextWindowPos says.
void show_tip(const Look& look, const char* text);

/// Begins a window that stays where it is, beside the picture. The renderer has filled what lies beside the picture with
/// the panel's colour, so that only one that covers the picture, or another one (`over_another`), needs a ground of its own.
void begin_beside(const PixelRect& picture, const char* id, ImVec2 at, ImVec2 size, ImGuiWindowFlags flags = 0,
                  bool over_another = false);

/// A heading that opens and closes what follows; what is put on the same line stands at its right.
bool section(const Look& look, const char* title, bool open_at_first = true);

/// As ImGui::BeginCombo.
bool begin_combo(const Look& look, const char* id, const std::string& current, float width);

struct IconButton {
    Icon icon;
    const char* about;  ///< for its tooltip
    bool enabled = true;
    float side = 30.0f;  ///< logical pixels
};
bool icon_button(const Look& look, const char* id, const IconButton& button);

/// As ImGui::Button; in the accent's colour if it is the one to press, or pressed.
bool accented_button(const Look& look, const char* label, bool accented = true, ImVec2 size = {});

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

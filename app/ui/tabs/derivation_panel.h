#pragma once

#include "core/frame/carried_arrows.h"
#include "core/frame/frame.h"
#include "core/math/highlight.h"
#include "core/scene/scene.h"
#include "ui/tabs/derivation_passages.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// Logical pixels.
inline constexpr float kDerivationWidth = 432.0f;

struct DerivationRoom {
    float top = 0.0f;    ///< what is left free above it, for the tabs
    bool to_all = true;  ///< nobody scrolls: smaller letters and more columns, where it must
};

/// The derivation at the right of the picture, with the scene's numbers. Each symbol is a name or a number, by click;
/// a lecturer may uncover line after line.
class DerivationPanel {
public:
    /// Does nothing without a room.
    void draw(const Look& look, const Scene& scene, const Frame& frame, const std::optional<DerivationRoom>& room);
    /// Logical pixels, as it was drawn last.
    float width() const { return column_width() * fit_.shrink * static_cast<float>(fit_.columns); }
    /// The laid-out lines hold fonts: to be called when these are made anew.
    void forget_layout() {
        laid_out_for_.reset();
        fitted_for_.reset();
    }

    /// Line by line, beginning at this one.
    void step_from(std::size_t line) { stepping_ = true, current_ = line, scroll_frames_ = 3; }
    void show_numbers() { shown_ = {.numbers = true}; }
    /// The line that is looked at, and v_obj's tangent; empty where all of them are, or it is none of the derivation's own.
    std::optional<DerivationAt> current() const {
        if (!stepping_ || current_ >= kDerivationLines) return std::nullopt;
        return DerivationAt{static_cast<DerivationLine>(current_), tangent_};
    }
    std::optional<Highlight> pointed_at() const { return pointed_at_; }
    void highlight(const std::optional<Highlight>& in_picture) { in_picture_ = in_picture; }

private:
    /// What the layout follows from.
    struct Basis {
        glm::dmat4 m{1.0};
        int rank = 3, factors = 0;
        std::vector<std::string> notes;
        std::optional<std::array<glm::dvec3, 4>> probe;  ///< point, normal, tangents
        std::size_t tangent = 0;
        NamesOrNumbers shown;
        float width = 0.0f;
        friend bool operator==(const Basis&, const Basis&) = default;
    };

    static constexpr float kMargin = 16.0f;
    static constexpr float kGutter = 26.0f;  ///< for a line's number and its mark
    static constexpr float kPad = 9.0f;      ///< above and below a line

    struct Fit {
        int columns = 1;
        float shrink = 1.0f;
        float narrow = 1.0f;  ///< of a column's width, beside its letters
    };
    /// What the fit follows from.
    struct Fitted {
        Basis basis;
        std::size_t lines = 0;
        ImVec2 room;
        friend bool operator==(const Fitted& a, const Fitted& b) {
            return a.basis == b.basis && a.lines == b.lines && a.room.x == b.room.x && a.room.y == b.room.y;
        }
    };

    Basis basis_of(const Scene& scene, const Frame& frame, float width) const;
    void lay_out(const Look& look, const Scene& scene, const Frame& frame);
    /// As large as all the lines can be seen at once in a room of that size.
    void fit(const Look& look, const Scene& scene, const Frame& frame, ImVec2 room);
    /// The lowest height of so many columns.
    float height_in(const Look& look, int columns) const;
    void draw_lines(const Look& look, float width, float height);
    std::size_t lines_shown() const { return stepping_ ? std::min(current_ + 1, passages_.size()) : passages_.size(); }
    void header(const Look& look);
    void progress(const Look& look);
    void keys();
    void go_to(std::size_t passage);
    float column_width() const { return kDerivationWidth * fit_.narrow; }
    float width_of_lines(const Look& look) const;
    bool fits_into_columns(const Look& look) const;
    static float height_of(const Look& look, const Passage& passage);
    float notes_height(const Look& look) const;
    void draw_notes(const Look& look, float width);
    void passage(const Look& look, std::size_t i, float width);
    void row(const Look& look, const Passage::Row& row, ImVec2 at);
    void part_tip(const Look& look, const MathBox::Part& part) const;
    std::optional<Highlight> highlight_of(const MathBox::Part& part) const;

    NamesOrNumbers shown_;
    std::size_t tangent_ = 0;
    bool stepping_ = false;
    int scroll_frames_ = 0;  ///< for so long, scroll to the current line
    std::size_t current_ = 0;
    std::optional<Highlight> pointed_at_, pointed_at_before_, in_picture_;

    Fit fit_;
    std::optional<Fitted> fitted_for_;
    std::optional<Basis> laid_out_for_;
    std::vector<Passage> passages_;
    std::vector<MathBox> notes_;
};

}  // namespace normalscope

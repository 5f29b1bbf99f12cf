// How all of the derivation is seen at once, where nobody scrolls.

#include "ui/tabs/derivation_panel.h"

#include <algorithm>
#include <numeric>

namespace normalscope {

namespace {

constexpr float kMostOfWidth = 0.62f;  // enough of a picture stays beside it
constexpr int kMostColumns = 3;

}  // namespace

float DerivationPanel::width_of_lines(const Look& look) const {
    return std::min(look.px(column_width()), ImGui::GetIO().DisplaySize.x) - 2 * look.px(kMargin) - look.px(kGutter);
}

float DerivationPanel::height_of(const Look& look, const Passage& passage) {
    float height = 2 * look.px(kPad);
    if (!passage.title.empty()) height += look.shrink * look.fonts.strong->FontSize + look.px(8);
    for (const Passage::Row& row : passage.rows) height += row.above + row.box.height();
    return height;
}

// Words break anywhere, but equations need their width.
bool DerivationPanel::fits_into_columns(const Look& look) const {
    return std::ranges::all_of(passages_, [&](const Passage& passage) {
        return std::ranges::all_of(passage.rows,
                                   [&](const Passage::Row& row) { return row.box.width <= width_of_lines(look); });
    });
}

float DerivationPanel::notes_height(const Look& look) const {
    if (notes_.empty()) return 0.0f;
    float height = look.px(8) + look.px(4);
    for (const MathBox& note : notes_) height += note.height() + look.px(8);
    return height;
}

float DerivationPanel::height_in(const Look& look, int columns) const {
    std::vector<float> heights{notes_height(look)};
    for (std::size_t i = 0; i < lines_shown(); ++i) heights.push_back(height_of(look, passages_[i]));
    const auto fits = [&](float most) {
        float height = 0.0f;
        int column = 1;
        for (const float each : heights) {
            if (height > 0.0f && height + each > most) ++column, height = 0.0f;
            height += each;
        }
        return column <= columns;
    };
    const float all = std::accumulate(heights.begin(), heights.end(), 0.0f);
    float most = std::max(all / static_cast<float>(columns), *std::ranges::max_element(heights));
    while (!fits(most)) most += 0.01f * all;
    return most;
}

void DerivationPanel::fit(const Look& look, const Scene& scene, const Frame& frame, ImVec2 room) {
    const Fitted wanted{basis_of(scene, frame, look.px(kDerivationWidth)), lines_shown(), room};
    if (fitted_for_ == wanted) return;
    Fit best{1, 0.0f};
    for (const float narrow : {1.0f, 0.85f, 0.7f}) {
        fit_.narrow = narrow;
        lay_out(look, scene, frame);
        if (narrow < 1.0f && !fits_into_columns(look)) break;
        for (int columns = 1; columns <= kMostColumns; ++columns) {
            const float shrink =
                std::min({1.0f, room.y / height_in(look, columns),
                          kMostOfWidth * room.x / (static_cast<float>(columns) * look.px(column_width()))});
            if (shrink > best.shrink) best = {columns, shrink, narrow};
        }
    }
    fit_.narrow = best.narrow;
    for (int i = 0; i < 4; ++i) {  // words are as wide as whole pixels have them
        const Look smaller = look.smaller(best.shrink);
        lay_out(smaller, scene, frame);
        if (height_in(smaller, best.columns) <= room.y) break;
        best.shrink *= 0.98f;
    }
    fit_ = best;
    fitted_for_ = wanted;
}

}  // namespace normalscope

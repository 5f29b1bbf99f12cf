#include "ui/kit/previews.h"

#include "core/base/error.h"
#include "core/lessons/open.h"
#include "core/picture/preview.h"

#include <algorithm>
#include <bit>

namespace normalscope {

namespace {

constexpr int kColumns = 6;
constexpr int kNarrowestAtlas = 512;
constexpr int kGap = 1;  // so that no tile shines through into its neighbour

Image drawn(const std::string& name, int side, const Stop& stop) {
    try {
        const Scene scene = load_scene(name);
        if (const auto* formula = std::get_if<FormulaSurface>(&scene.surface))
            return preview(ImplicitSurface(*formula), scene.camera, side, stop);
    } catch (const Error&) {  // a tile without a picture still opens the scene, and that says why
    }
    return make_image(glm::ivec2(side));
}

}  // namespace

void Previews::want(const std::vector<std::string>& scenes, int side) {
    if (side == side_ && scenes == scenes_) return;
    drawing_.clear();
    begun_ = 0;
    scenes_ = scenes;
    side_ = side;
    has_room_ = false;
    pictures_.assign(scenes.size(), {});
    in_atlas_.assign(scenes.size(), false);
    draw_more();
}

// No more at once than there are processors.
void Previews::draw_more() {
    for (; begun_ < scenes_.size() && drawing_.size() < threads_for(scenes_.size(), 1); ++begun_)
        drawing_.push_back(
            beside([name = scenes_[begun_], side = side_](const Stop& stop) { return drawn(name, side, stop); }));
}

void Previews::reserve(ImFontAtlas& atlas) {
    has_room_ = side_ > 0;
    std::fill(in_atlas_.begin(), in_atlas_.end(), false);
    if (!has_room_) return;
    const int rows = (static_cast<int>(scenes_.size()) + kColumns - 1) / kColumns;
    const int width = (side_ + kGap) * kColumns;
    // Dear ImGui makes an atlas as wide as its letters need, and leaves out what is wider.
    if (width >= kNarrowestAtlas) atlas.TexDesiredWidth = std::max(2048, static_cast<int>(std::bit_ceil(width + 1u)));
    rect_ = atlas.AddCustomRectRegular(width, (side_ + kGap) * rows);
}

void Previews::place(ImFontAtlas& atlas) {
    if (!has_room_) return;
    const ImFontAtlasCustomRect* rect = atlas.GetCustomRectByIndex(rect_);
    texel_ = {1.0f / static_cast<float>(atlas.TexWidth), 1.0f / static_cast<float>(atlas.TexHeight)};
    origin_ = {rect->X, rect->Y};
    (void)update(atlas);
}

bool Previews::update(ImFontAtlas& atlas) {
    if (!has_room_) return false;
    for (; !drawing_.empty() && drawing_.front().ready(); drawing_.pop_front())
        pictures_[begun_ - drawing_.size()] = drawing_.front().get();
    draw_more();
    bool any = false;
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
        if (in_atlas_[i] || pictures_[i].rgba.empty()) continue;
        unsigned char* pixels = nullptr;
        int width = 0;
        atlas.GetTexDataAsRGBA32(&pixels, &width, nullptr);
        const glm::ivec2 at = corner(i);
        for (int y = 0; y < side_; ++y)
            std::copy_n(pictures_[i].pixel(0, y), 4 * side_,
                        pixels + 4 * (static_cast<std::ptrdiff_t>(at.y + y) * width + at.x));
        in_atlas_[i] = any = true;
    }
    return any;
}

glm::ivec2 Previews::corner(std::size_t i) const {
    const int at = static_cast<int>(i);
    return origin_ + (side_ + kGap) * glm::ivec2(at % kColumns, at / kColumns);
}

std::optional<Previews::Tile> Previews::tile(std::size_t i) const {
    if (!has_room_ || i >= in_atlas_.size() || !in_atlas_[i]) return std::nullopt;
    const glm::vec2 low(corner(i)), high = low + static_cast<float>(side_);
    return Tile{{low.x * texel_.x, low.y * texel_.y}, {high.x * texel_.x, high.y * texel_.y}};
}

}  // namespace normalscope

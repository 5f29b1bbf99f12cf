#include "ui/kit/previews.h"

#include "core/base/error.h"
#include "core/lessons/open_scene.h"
#include "core/picture/preview.h"

#include <algorithm>
#include <mutex>
#include <thread>
#include <utility>

namespace normalscope {

/// What the drawing thread and the interface share.
struct Previews::Work {
    std::mutex mutex;
    std::vector<std::pair<std::size_t, Image>> finished;
    std::size_t left = 0;
    std::jthread thread;  // last: it ends before the rest goes
};

namespace {

constexpr int kColumns = 6;
constexpr int kGap = 1;  // so that no tile shines through into its neighbour

Image drawn(const std::string& name, int side, const std::stop_token& stop) {
    try {
        const Scene scene = load_scene(name);
        if (const auto* formula = std::get_if<FormulaSurface>(&scene.surface))
            return preview(ImplicitSurface(*formula), scene.camera, side, stop);
    } catch (const Error&) {  // a tile without a picture still opens the scene, and that says why
    }
    return make_image(glm::ivec2(side));
}

}  // namespace

Previews::Previews() = default;
Previews::~Previews() = default;

void Previews::want(const std::vector<std::string>& scenes, int side) {
    if (side == side_ && scenes == scenes_) return;
    work_ = std::make_unique<Work>();
    scenes_ = scenes;
    side_ = side;
    has_room_ = false;
    pictures_.assign(scenes.size(), {});
    in_atlas_.assign(scenes.size(), false);
    work_->left = scenes.size();
    work_->thread = std::jthread([&work = *work_, scenes, side](const std::stop_token& stop) {
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            Image picture = drawn(scenes[i], side, stop);
            if (stop.stop_requested()) return;
            const std::scoped_lock lock(work.mutex);
            work.finished.emplace_back(i, std::move(picture));
            --work.left;
        }
    });
}

void Previews::reserve(ImFontAtlas& atlas) {
    has_room_ = side_ > 0;
    std::fill(in_atlas_.begin(), in_atlas_.end(), false);
    if (!has_room_) return;
    const int rows = (static_cast<int>(scenes_.size()) + kColumns - 1) / kColumns;
    rect_ = atlas.AddCustomRectRegular((side_ + kGap) * kColumns, (side_ + kGap) * rows);
}

void Previews::place(ImFontAtlas& atlas) {
    if (!has_room_) return;
    const ImFontAtlasCustomRect* rect = atlas.GetCustomRectByIndex(rect_);
    texel_ = {1.0f / static_cast<float>(atlas.TexWidth), 1.0f / static_cast<float>(atlas.TexHeight)};
    origin_ = {rect->X, rect->Y};
    (void)update(atlas);
}

bool Previews::update(ImFontAtlas& atlas) {
    if (!work_ || !has_room_) return false;
    {
        const std::scoped_lock lock(work_->mutex);
        for (auto& [i, picture] : work_->finished) pictures_[i] = std::move(picture);
        work_->finished.clear();
    }
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

bool Previews::busy() const {
    if (!work_) return false;
    const std::scoped_lock lock(work_->mutex);
    return work_->left > 0 || !work_->finished.empty();
}

std::optional<Previews::Tile> Previews::tile(std::size_t i) const {
    if (!has_room_ || i >= in_atlas_.size() || !in_atlas_[i]) return std::nullopt;
    const glm::vec2 low(corner(i)), high = low + static_cast<float>(side_);
    return Tile{{low.x * texel_.x, low.y * texel_.y}, {high.x * texel_.x, high.y * texel_.y}};
}

}  // namespace normalscope

#pragma once

#include "core/base/beside.h"
#include "core/image/image.h"

#include <imgui.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// Small pictures of scenes, drawn in the background and kept in the font atlas: so that whatever draws the interface
/// needs no textures but the one that it has.
class Previews {
public:
    /// Begins to draw these built-in scenes, `side` pixels wide and high. Nothing where that is what it does already.
    void want(const std::vector<std::string>& scenes, int side);
    /// True where the atlas has no room for what is wanted: it must be made anew.
    bool needs_room() const { return side_ > 0 && !has_room_; }
    /// Before the atlas is built, and after.
    void reserve(ImFontAtlas& atlas);
    void place(ImFontAtlas& atlas);
    /// Puts what has been finished into the atlas; true where there was something.
    bool update(ImFontAtlas& atlas);
    /// Some are still being drawn.
    bool busy() const { return !drawing_.empty(); }

    struct Tile {
        ImVec2 low, high;  ///< texture coordinates
    };
    /// Empty as long as it is not finished.
    std::optional<Tile> tile(std::size_t i) const;

private:
    /// Where a tile lies in the atlas, in pixels.
    glm::ivec2 corner(std::size_t i) const;

    void draw_more();

    std::vector<std::string> scenes_;
    int side_ = 0;
    bool has_room_ = false;
    int rect_ = -1;                ///< in the atlas
    std::vector<Image> pictures_;  ///< of size 0 as long as they are not finished
    std::vector<bool> in_atlas_;
    ImVec2 texel_{0, 0};
    glm::ivec2 origin_{0};
    std::size_t begun_ = 0;                ///< scenes that are or were drawn
    std::deque<Beside<Image>> drawing_{};  ///< the last of them
};

}  // namespace normalscope

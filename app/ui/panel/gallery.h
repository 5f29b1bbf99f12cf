#pragma once

#include "core/lessons/open.h"
#include "ui/kit/previews.h"
#include "ui/panel/panel_context.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// Where the gallery is to stand in the panel, below the upper edge, until the scene that was chosen is there: what is
/// above it changes with the scene, and the tiles should not move from under the pointer.
struct GalleryPlace {
    float at = 0.0f;
    std::string awaited;  ///< may be empty
    int frames = 3;       ///< until the panel has settled, then
};

/// Surfaces by formula to choose from, each with its picture and the fact that it teaches.
struct GalleryMemory {
    Previews previews;
    std::vector<BuiltInScene> scenes;  ///< read at the first look
    std::optional<std::size_t> told;   ///< which of them the pointer or the keyboard was on
    bool open = false;
    bool only_surface = false;  ///< a choice changes the surface and nothing else

    void toggle();
    /// Open, and in sight.
    void show();
    bool wanted = false;  ///< to be scrolled to
    std::optional<GalleryPlace> place;
};

void gallery(Scene& scene, GalleryMemory& memory, const PanelContext& context);

}  // namespace normalscope

#pragma once

#include "ui/panel.h"
#include "ui/previews.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace normalscope {

/// Surfaces by formula to choose from, each with its picture and the fact that it teaches.
struct GalleryMemory {
    Previews previews;
    std::vector<BuiltInScene> scenes;  ///< read at the first look
    std::optional<std::size_t> told;   ///< which of them the pointer or the keyboard was on
    bool open = false;
    bool only_surface = false;  ///< a choice changes the surface and nothing else
};

void gallery(Scene& scene, GalleryMemory& memory, const PanelContext& context);

}  // namespace normalscope

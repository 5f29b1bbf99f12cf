#pragma once

#include "ui/formula_section.h"
#include "ui/gallery.h"
#include "ui/panel.h"
#include "ui/stack_section.h"

namespace normalscope {

/// What the panel remembers from frame to frame.
struct PanelMemory {
    std::vector<BuiltInScene> scenes;  ///< read at the first look
    StackMemory stack;
    FormulaMemory formula;
    GalleryMemory gallery;
    std::optional<WrittenFormula> at_probe;
};

}  // namespace normalscope

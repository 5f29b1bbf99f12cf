#pragma once

#include "core/lessons/open.h"
#include "ui/panel/formula_section.h"
#include "ui/panel/gallery.h"
#include "ui/panel/panel_context.h"
#include "ui/panel/stack_section.h"

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

#pragma once

#include "core/surface/implicit_surface.h"

#include <string>

namespace normalscope {

/// Why there is less to be seen of a formula than one may expect; empty where there is not.
struct FormulaNote {
    std::string text;
    bool drawn = true;  ///< else it says that nothing is drawn, and nothing may be
};

/// `mesh` is what it was polygonised to. Throws Stopped (core/surface/stopped.h).
FormulaNote note_on(const ImplicitSurface& surface, const Mesh& mesh, const Stop& stop = {});

}  // namespace normalscope

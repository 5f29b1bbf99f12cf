#include "core/picture/way_of_drawing.h"

namespace normalscope {

namespace {

bool may_be_traced(const Surface& surface) { return surface.implicit && surface.implicit->region(); }

// A driver takes minutes to compile ten times as many, and as long to draw them.
bool is_too_long(const Surface& surface) {
    constexpr std::size_t kMostSteps = 1000;
    return surface.implicit->program().size() > kMostSteps && !surface.mesh.triangles.empty();
}

}  // namespace

bool is_traced(const Surface& surface) { return may_be_traced(surface) && !is_too_long(surface); }

std::string_view note_on_triangles(const Surface& surface, const Transform<World, Object>& world_from_object) {
    if (!may_be_traced(surface)) return {};
    if (is_too_long(surface))
        return "the formula is so long that its surface is drawn as triangles instead of being traced pixel by pixel; "
               "its "
               "outline and its shading are as coarse as they are";
    if (!world_from_object.affine())
        return "M is not affine, so the formula's surface is drawn as triangles instead of being traced pixel by "
               "pixel; its "
               "outline and its shading are as coarse as they are";
    return {};
}

}  // namespace normalscope

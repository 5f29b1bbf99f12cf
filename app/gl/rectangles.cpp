#include "gl/rectangles.h"

#include "gl/gl.h"

#include <glm/common.hpp>

namespace normalscope {

PixelRect upright(PixelRect rect, const Target& target) {
    rect.origin.y = target.size().y - rect.origin.y - rect.size.y;
    return rect;
}

void scissor(const PixelRect& rect) { glScissor(rect.origin.x, rect.origin.y, rect.size.x, rect.size.y); }

void look_at(const PixelRect& rect) {
    glViewport(rect.origin.x, rect.origin.y, rect.size.x, rect.size.y);
    scissor(rect);
}

PixelRect common(const PixelRect& a, const PixelRect& b) {
    const glm::ivec2 end = a.origin + a.size, low = glm::clamp(b.origin, a.origin, end);
    return {low, glm::clamp(b.origin + b.size, low, end) - low};
}

std::array<PixelRect, 4> around(const PixelRect& whole, const PixelRect& part) {
    const glm::ivec2 low = whole.origin, end = low + whole.size, from = part.origin, to = from + part.size;
    return {PixelRect{low, {whole.size.x, from.y - low.y}},
            {{low.x, to.y}, {whole.size.x, end.y - to.y}},
            {{low.x, from.y}, {from.x - low.x, part.size.y}},
            {{to.x, from.y}, {end.x - to.x, part.size.y}}};
}

}  // namespace normalscope

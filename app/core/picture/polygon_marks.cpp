#include "core/picture/polygon_marks.h"

#include "core/frame/solids.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

namespace {

// Zero where the corners have come to lie in a line.
glm::dvec3 normal_of(std::span<const glm::dvec3> ring) {
    const glm::dvec3 n = glm::cross(ring[1] - ring[0], ring[2] - ring[1]);
    return glm::length(n) > 0.0 ? glm::normalize(n) : glm::dvec3(0.0);
}

class Marks {
public:
    Marks(Pane& pane, const FrameOptions& options) : pane_(pane), options_(options) {}

    void polygon(std::span<const glm::dvec3> corners, const glm::vec3& color, double wide) {
        // A little off the surface, within which it would flicker.
        const glm::dvec3 n = normal_of(corners), toward_eye = pane_.view.eye().xyz - corners.front();
        const double lift = 0.008 * options_.unit * (glm::dot(n, toward_eye) < 0.0 ? -1.0 : 1.0);
        std::vector<glm::dvec3> ring;
        for (const glm::dvec3& corner : corners) ring.push_back(corner + lift * n);
        add_polygon(pane_.translucent, ring, glm::vec4(color, 0.2f));
        const double pixel = options_.pixel_scale * pane_.view.world_per_pixel({ring.front()});
        if (options_.marks.line) return add_tube(pane_.solids, ring, pixel, glm::vec4(color, 1.0f), true);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec3 &from = ring[i], &to = ring[(i + 1) % ring.size()];
            const double radius = wide * std::max(0.011 * options_.unit, 1.7 * pixel);
            add_arrow(pane_.solids, from, to - from, radius, glm::vec4(color, 1.0f));
            pane_.strokes.push_back({from, to, ArrowProportions::kHeadRadius * radius});
        }
    }

    /// Beside the corner that is the lowest in the picture, where no arrow of a normal stands.
    void name(std::span<const glm::dvec3> corners, const std::string& text, const glm::vec3& color) {
        const auto lowest = std::ranges::max_element(
            corners, {}, [&](const glm::dvec3& corner) { return pane_.view.pixel({corner}).y; });
        pane_.wanted.push_back({*lowest, text, color});
    }

private:
    Pane& pane_;
    const FrameOptions& options_;
};

template <class Space>
std::vector<glm::dvec3> places(const std::vector<Point<Space>>& points) {
    std::vector<glm::dvec3> result;
    for (const Point<Space>& point : points) result.push_back(point.xyz);
    return result;
}

}  // namespace

void add_polygon_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe, bool ghost,
                       const FrameOptions& options) {
    if (probe.object.polygon.empty()) return;
    const glm::vec3 grey = arrow_color(ArrowKind::Object, scene.theme);
    const std::vector<glm::dvec3> h = places(probe.object.polygon), mh = places(probe.polygon);
    Marks marks(pane, options);
    if (ghost) marks.polygon(h, grey, ArrowProportions::kOfObject);
    if (!mh.empty()) marks.polygon(mh, kTangentColor, 1.0);
    if (ghost) marks.name(h, "H", grey);
    if (!mh.empty()) marks.name(mh, "MH", kTangentColor);
}

}  // namespace normalscope

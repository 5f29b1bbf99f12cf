#include "core/image/perceived_difference.h"

#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

glm::dvec3 color_over(double ground, const std::uint8_t* p) {
    const double alpha = p[3] / 255.0;
    return ground * (1.0 - alpha) + alpha * glm::dvec3(p[0], p[1], p[2]);
}

double luma(const std::uint8_t* p) { return glm::dot(color_over(255.0, p), {0.299, 0.587, 0.114}); }

double distance_over(double ground, const std::uint8_t* a, const std::uint8_t* b) {
    constexpr glm::dmat3 kYiqFromRgb{0.299, 0.596, 0.211, 0.587, -0.274, -0.523, 0.114, -0.322, 0.312};  // by columns
    constexpr glm::dvec3 kWeights{0.5053, 0.299, 0.1957};
    const glm::dvec3 d = kYiqFromRgb * (color_over(ground, a) - color_over(ground, b));
    return std::sqrt(glm::dot(kWeights, d * d) / kWeights.x);  // so that greys count as themselves
}

// The pixels about p that the picture has, p left out.
template <class F>
void for_neighbours(const Image& image, glm::ivec2 p, F&& f) {
    for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, image.size.y - 1); ++y)
        for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, image.size.x - 1); ++x)
            if (glm::ivec2(x, y) != p) f(glm::ivec2(x, y));
}

bool at_border(const Image& image, glm::ivec2 p) {
    return p.x == 0 || p.y == 0 || p.x == image.size.x - 1 || p.y == image.size.y - 1;
}

// At least three neighbours are just like it; beyond the border the picture may well go on so.
bool in_plain_area(const Image& image, glm::ivec2 p) {
    int alike = at_border(image, p) ? 1 : 0;
    const std::uint8_t* pixel = image.pixel(p.x, p.y);
    for_neighbours(image, p, [&](glm::ivec2 q) {
        if (std::equal(pixel, pixel + 4, image.pixel(q.x, q.y))) ++alike;
    });
    return alike >= 3;
}

bool smooths_an_edge_of(const Image& image, const Image& other, glm::ivec2 p) {
    const double own = luma(image.pixel(p.x, p.y));
    int alike = at_border(image, p) ? 1 : 0;
    double darkest = 0.0, brightest = 0.0;
    glm::ivec2 darkest_at = p, brightest_at = p;
    for_neighbours(image, p, [&](glm::ivec2 q) {
        const double step = luma(image.pixel(q.x, q.y)) - own;
        if (step == 0.0) ++alike;
        if (step < darkest) darkest = step, darkest_at = q;
        if (step > brightest) brightest = step, brightest_at = q;
    });
    if (alike > 2 || darkest == 0.0 || brightest == 0.0) return false;
    const auto plain_in_both = [&](glm::ivec2 q) { return in_plain_area(image, q) && in_plain_area(other, q); };
    return plain_in_both(darkest_at) || plain_in_both(brightest_at);
}

}  // namespace

double perceived_difference(const Image& a, const Image& b, glm::ivec2 p) {
    const std::uint8_t *in_a = a.pixel(p.x, p.y), *in_b = b.pixel(p.x, p.y);
    if (std::equal(in_a, in_a + 4, in_b)) return 0.0;
    const double on_white = distance_over(255.0, in_a, in_b);
    return in_a[3] == 255 && in_b[3] == 255 ? on_white : std::max(on_white, distance_over(0.0, in_a, in_b));
}

bool smooths_an_edge(const Image& a, const Image& b, glm::ivec2 p) {
    return smooths_an_edge_of(a, b, p) || smooths_an_edge_of(b, a, p);
}

}  // namespace normalscope

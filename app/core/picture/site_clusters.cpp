#include "core/picture/site_clusters.h"

#include "core/frame/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace normalscope {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kCells = 16;  // a side of the grid: some hundred of its cells hold a part of a surface

SiteCluster cluster_of(std::span<const Site> sites, std::span<const std::uint32_t> indices, std::size_t first) {
    SiteCluster cluster{first,
                        indices.size(),
                        glm::dvec3(kInfinity),
                        glm::dvec3(-kInfinity),
                        glm::dvec3(kInfinity),
                        glm::dvec3(-kInfinity)};
    for (const std::uint32_t i : indices) {
        const Site& site = sites[i];
        cluster.low = glm::min(cluster.low, site.point.xyz);
        cluster.high = glm::max(cluster.high, site.point.xyz);
        cluster.normal_low = glm::min(cluster.normal_low, site.normal.xyz);
        cluster.normal_high = glm::max(cluster.normal_high, site.normal.xyz);
    }
    return cluster;
}

}  // namespace

SiteClusters site_clusters(std::span<const Site> sites) {
    glm::dvec3 low(kInfinity), high(-kInfinity);
    for (const Site& site : sites) {
        low = glm::min(low, site.point.xyz);
        high = glm::max(high, site.point.xyz);
    }
    const glm::dvec3 sides = high - low;
    const double side = std::max({sides.x, sides.y, sides.z});
    const double scale = side > 0.0 ? kCells / side : 0.0;
    const auto cell = [&](const Site& site) {
        const glm::ivec3 c = glm::min(glm::ivec3(scale * (site.point.xyz - low)), kCells - 1);
        const int index = (c.z * kCells + c.y) * kCells + c.x;
        return static_cast<std::size_t>(index);
    };
    std::vector<std::size_t> ends(std::size_t{kCells} * kCells * kCells + 1, 0);
    for (const Site& site : sites) ++ends[cell(site) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    SiteClusters result;
    result.order.resize(sites.size());
    // Afterwards each cell's start is its end.
    for (std::size_t i = 0; i < sites.size(); ++i) result.order[ends[cell(sites[i])]++] = static_cast<std::uint32_t>(i);
    std::size_t first = 0;
    for (const std::size_t end : ends)
        for (; first < end;) {
            const std::size_t count = std::min(SiteClusters::kMost, end - first);
            result.clusters.push_back(cluster_of(sites, std::span(result.order).subspan(first, count), first));
            first += count;
        }
    return result;
}

namespace {

// Where a linear map sends a box: another one.
WorldBox sent_box(const glm::dmat3& m, const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
    const glm::dvec3 centre = m * middle;
    const glm::dvec3 reach = glm::dmat3(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])) * half;
    return {centre - reach, centre + reach};
}

// All vectors in a box, made of unit length.
WorldBox unit_box(const WorldBox& box) {
    const double least = glm::length(glm::max(glm::max(box.low, -box.high), glm::dvec3(0.0)));
    const double most = glm::length(glm::max(glm::abs(box.low), glm::abs(box.high)));
    if (!(least > 1e-6 * most)) return {glm::dvec3(-1.0), glm::dvec3(1.0)};
    WorldBox unit;
    for (int k = 0; k < 3; ++k) {
        unit.low[k] = std::max(-1.0, box.low[k] / (box.low[k] < 0.0 ? least : most));
        unit.high[k] = std::min(1.0, box.high[k] / (box.high[k] > 0.0 ? least : most));
    }
    return unit;
}

}  // namespace

std::optional<WorldBox> arrows_box(const SiteCluster& cluster, const ArrowDraw& draw) {
    WorldBox box{glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 at(corner & 1 ? cluster.high.x : cluster.low.x, corner & 2 ? cluster.high.y : cluster.low.y,
                            corner & 4 ? cluster.high.z : cluster.low.z, 1.0);
        const glm::dvec4 world = glm::dmat4(draw.world_from_object) * at;
        if (!(world.w > 0.0)) return std::nullopt;
        box.low = glm::min(box.low, glm::dvec3(world) / world.w);
        box.high = glm::max(box.high, glm::dvec3(world) / world.w);
    }
    WorldBox sent = sent_box(glm::dmat3(draw.normals.matrix), cluster.normal_low, cluster.normal_high);
    const glm::dvec3 shift = draw.normals.w * glm::dvec3(draw.normals.matrix[3]);
    sent = unit_box({sent.low + shift, sent.high + shift});
    const double length = (draw.normals.at_pixels ? 1.0 : 3.0) * double(draw.length);  // scene.vert: left as they are
    const glm::dvec3 furthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    const glm::dvec3 around =
        ArrowProportions::kHeadRadius * double(draw.radius) + 1e-5 * (furthest + length);  // floats
    box.low += length * glm::min(sent.low, glm::dvec3(0.0)) - around;
    box.high += length * glm::max(sent.high, glm::dvec3(0.0)) + around;
    const glm::dvec3 sum = glm::abs(box.low) + glm::abs(box.high);
    return std::isfinite(sum.x + sum.y + sum.z) ? std::optional(box) : std::nullopt;
}

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace normalscope {

/// Sites near one another, so few that other things hide all of their arrows or that it hardly matters.
struct SiteCluster {
    std::size_t first = 0, count = 0;  ///< in SiteClusters::order
    glm::dvec3 low{0.0}, high{0.0};    ///< their points' box, in object space
    glm::dvec3 normal_low{0.0}, normal_high{0.0};
};

struct SiteClusters {
    static constexpr std::size_t kMost = 4096;  ///< sites in one

    std::vector<std::uint32_t> order;  ///< the sites' indices, cluster by cluster
    std::vector<SiteCluster> clusters;
};

/// By the cells of a grid over the surface. Finite points, at most 2³² of them.
SiteClusters site_clusters(std::span<const Site> sites);

struct WorldBox {
    glm::dvec3 low{0.0}, high{0.0};
};

/// Holds all of a cluster's arrows as scene.vert draws them; empty where a projective matrix may send one beyond infinity,
/// or a number is too large.
std::optional<WorldBox> arrows_box(const SiteCluster& cluster, const ArrowDraw& draw);

}  // namespace normalscope

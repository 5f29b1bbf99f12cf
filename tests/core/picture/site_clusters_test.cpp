#include "core/picture/site_clusters.h"

#include "random.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <vector>

namespace normalscope {
namespace {

bool within(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high) {
    return glm::all(glm::lessThanEqual(low, p)) && glm::all(glm::lessThanEqual(p, high));
}

// On a patch of a sphere, so that their normals are alike; some without a normal.
std::vector<Site> random_sites(Random& random) {
    std::vector<Site> sites(static_cast<std::size_t>(random.below(20'000)));
    const glm::dvec3 toward = random.direction();
    for (Site& site : sites) {
        const glm::dvec3 n = glm::normalize(toward + 0.7 * random.direction());
        site = {{n}, {random.below(50) == 0 ? glm::dvec3(0.0) : n}};
    }
    return sites;
}

TEST(SiteClusters, HoldEverySiteOnceAndInTheirBoxes) {
    Random random(61);
    for (int i = 0; i < 40; ++i) {
        std::vector<Site> sites = random_sites(random);
        if (i % 5 == 0)
            for (Site& site : sites) site.point.xyz = {1.0, 2.0, 3.0};
        const SiteClusters in_clusters = site_clusters(sites);
        std::vector<bool> held(sites.size(), false);
        std::size_t next = 0;
        for (const SiteCluster& cluster : in_clusters.clusters) {
            ASSERT_EQ(cluster.first, next);
            ASSERT_GT(cluster.count, 0u);
            ASSERT_LE(cluster.count, SiteClusters::kMost);
            next += cluster.count;
            for (std::size_t k = cluster.first; k < next; ++k) {
                const std::uint32_t index = in_clusters.order[k];
                ASSERT_FALSE(held.at(index));
                held[index] = true;
                EXPECT_TRUE(within(sites[index].point.xyz, cluster.low, cluster.high));
                EXPECT_TRUE(within(sites[index].normal.xyz, cluster.normal_low, cluster.normal_high));
            }
        }
        EXPECT_EQ(next, sites.size());
    }
}

TEST(SiteClusters, ArrowsLieInTheBoxesOfTheirClusters) {
    Random random(62);
    int boxes = 0;
    for (int i = 0; i < 200; ++i) {
        const std::vector<Site> sites = random_sites(random);
        const SiteClusters in_clusters = site_clusters(sites);
        ArrowDraw draw;
        draw.world_from_object = glm::mat4(glm::dmat4(random.matrix()));
        draw.normals.matrix = glm::dmat4(random.matrix());
        draw.normals.at_pixels = i % 3 != 0;
        if (i % 4 == 0) {
            draw.normals.w = 1.0;
            draw.normals.matrix[3] = glm::dvec4(random.direction(), 1.0);
        }
        if (i % 7 == 0)
            for (int c = 0; c < 4; ++c) draw.world_from_object[c].w = static_cast<float>(random.uniform(-0.4, 0.4));
        draw.length = static_cast<float>(random.uniform(0.01, 1.0));
        draw.radius = 0.1f * draw.length;
        for (const SiteCluster& cluster : in_clusters.clusters) {
            const std::optional<WorldBox> box = arrows_box(cluster, draw);
            if (!box) continue;
            ++boxes;
            for (std::size_t k = cluster.first; k < cluster.first + cluster.count; ++k) {
                const Site& site = sites[in_clusters.order[k]];
                const glm::dvec4 base = glm::dmat4(draw.world_from_object) * glm::dvec4(site.point.xyz, 1.0);
                ASSERT_TRUE(within(glm::dvec3(base) / base.w, box->low, box->high));
                const glm::dvec3 n = draw.normals(site.normal).xyz;
                if (n == glm::dvec3(0.0)) continue;
                const double factor = draw.normals.at_pixels ? 1.0 : std::min(glm::length(n), 3.0);
                const glm::dvec3 tip = glm::dvec3(base) / base.w + factor * double(draw.length) * glm::normalize(n);
                ASSERT_TRUE(within(tip, box->low, box->high));
            }
        }
    }
    EXPECT_GT(boxes, 10'000);
}

}  // namespace
}  // namespace normalscope

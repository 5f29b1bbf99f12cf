#pragma once

#include "core/math/space.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace normalscope {

/// Where a mesh's vertex normals come from.
enum class NormalSource { Exact, File, Computed };

/// A triangulated surface in object space. Triangles are counterclockwise seen from outside.
/// Vertices come coarse to fine where the maker can arrange it, so that thinning in order gives a regular pattern.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;    ///< one a position, of unit length; zero where there is none
    std::vector<glm::uvec3> triangles;  ///< indices into positions
    /// The polygon that each triangle is part of, ascending; empty where every triangle is a face of its own.
    std::vector<std::uint32_t> face_of_triangle;
    bool closed = false;  ///< known to have no opening: from outside, no triangle shows its back
    NormalSource normal_source = NormalSource::Exact;
    /// What the maker has to tell the user, a line each, such as that normals had to be computed.
    std::vector<std::string> notes;

    std::size_t face_count() const {
        return face_of_triangle.empty() ? triangles.size() : face_of_triangle.back() + std::size_t{1};
    }
};

/// A place on a surface with its normal: where an arrow starts, what a probe shows.
struct Site {
    Point<Object> point;
    Normal<Object> normal;  ///< of unit length
};

/// Area-weighted vertex normals: the cross product of a triangle's edges is twice its area long, so their plain sum
/// weighs by area. Zero where all of a vertex's triangles are degenerate.
std::vector<glm::dvec3> area_weighted_normals(const std::vector<glm::dvec3>& positions,
                                              const std::vector<glm::uvec3>& triangles);

/// Where two faces meet at more than this they meet in an edge, and not in what stands for a smooth surface.
inline constexpr double kCreaseDegrees = 60.0;

/// Gives vertices without a normal (zero) area-weighted ones, sharp at creases: each side of a crease gets vertices of
/// its own, and faces around a vertex stay together where one is reached from the other across edges that are no creases.
/// True where there is such a crease.
bool complete_normals(Mesh& mesh);

/// One site a face: the area centroid and the face's unit normal (of its triangles' area vectors); zero-area faces are left out.
std::vector<Site> face_sites(const Mesh& mesh);
/// One site a vertex; vertices without a normal are left out.
std::vector<Site> vertex_sites(const Mesh& mesh);

/// Every n-th site, then so many of the rest as `limit` allows, evenly spread over the surface: a site is taken in
/// order unless one already taken is nearer than a radius chosen from the surface's area.
std::vector<Site> thinned(std::vector<Site> sites, std::size_t every, std::size_t limit, double surface_area);

double surface_area(const Mesh& mesh);
/// How much of the surface each vertex stands for: a third of each of its triangles. What has no area, or no triangles, has 1
/// everywhere.
std::vector<double> vertex_areas(const Mesh& mesh);

/// Moves and scales the mesh so that its bounding box is centred on the origin and it touches the unit sphere from within.
void fit_to_unit_sphere(Mesh& mesh);

}  // namespace normalscope

#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace normalscope {

// Tags: the space in which coordinates are meant. A point of one space cannot meet a vector of another.
struct Object {};
struct World {};

/// A place. Moves by M, translation included.
template <class Space>
struct Point {
    glm::dvec3 xyz{0.0};
    friend bool operator==(const Point&, const Point&) = default;
};

/// A difference of places, such as a tangent or a ray's direction. Moves by M3: translation does not touch it.
template <class Space>
struct Vector {
    glm::dvec3 xyz{0.0};
    friend bool operator==(const Vector&, const Vector&) = default;
};

/// What is perpendicular to a surface's tangents. Moves by the inverse transpose of M3, so it is a type of its own;
/// not necessarily of unit length.
template <class Space>
struct Normal {
    glm::dvec3 xyz{0.0};
    friend bool operator==(const Normal&, const Normal&) = default;
};

template <class S>
Vector<S> operator-(Point<S> a, Point<S> b) {
    return {a.xyz - b.xyz};
}
template <class S>
Point<S> operator+(Point<S> p, Vector<S> v) {
    return {p.xyz + v.xyz};
}
template <class S>
Vector<S> operator+(Vector<S> a, Vector<S> b) {
    return {a.xyz + b.xyz};
}
template <class S>
Vector<S> operator-(Vector<S> v) {
    return {-v.xyz};
}
template <class S>
Vector<S> operator*(double s, Vector<S> v) {
    return {s * v.xyz};
}
template <class S>
Normal<S> operator*(double s, Normal<S> n) {
    return {s * n.xyz};
}

/// The one product that a normal is made for: zero says that `v` is tangent.
template <class S>
double dot(Normal<S> n, Vector<S> v) {
    return glm::dot(n.xyz, v.xyz);
}
template <class S>
double dot(Vector<S> a, Vector<S> b) {
    return glm::dot(a.xyz, b.xyz);
}

/// Two tangents span a surface element; its normal follows their order, as a triangle's follows its winding.
template <class S>
Normal<S> cross(Vector<S> a, Vector<S> b) {
    return {glm::cross(a.xyz, b.xyz)};
}

}  // namespace normalscope

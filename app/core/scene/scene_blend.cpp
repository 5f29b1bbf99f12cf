#include "core/scene/scene_blend.h"

#include "core/base/overload.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

double mixed(double a, double b, double t) { return a + (b - a) * t; }

// The shorter way round.
double mixed_azimuth(double a, double b, double t) { return a + std::remainder(b - a, 360.0) * t; }

bool same_axis(const Rotate& a, const Rotate& b) {
    return glm::length(glm::cross(glm::normalize(a.axis), glm::normalize(b.axis))) < 1e-12 &&
           glm::dot(a.axis, b.axis) > 0.0;
}

// Whether there is a straight way from one to the other.
bool alike(const StackEntry& a, const StackEntry& b) {
    if (a.index() != b.index()) return false;
    const Rotate* r = std::get_if<Rotate>(&a);
    return !r || same_axis(*r, std::get<Rotate>(b));
}

StackEntry mixed(const StackEntry& a, const StackEntry& b, double t) {
    return std::visit(
        Overload{
            [&](const Scale& s) -> StackEntry { return Scale{glm::mix(s.factors, std::get<Scale>(b).factors, t)}; },
            [&](const Rotate& r) -> StackEntry {
                return Rotate{std::get<Rotate>(b).axis, mixed(r.degrees, std::get<Rotate>(b).degrees, t)};
            },
            [&](const Translate& m) -> StackEntry {
                return Translate{glm::mix(m.offset, std::get<Translate>(b).offset, t)};
            },
            [&](const Shear& s) -> StackEntry {
                const Shear& e = std::get<Shear>(b);
                return Shear{mixed(s.xy, e.xy, t), mixed(s.xz, e.xz, t), mixed(s.yx, e.yx, t),
                             mixed(s.yz, e.yz, t), mixed(s.zx, e.zx, t), mixed(s.zy, e.zy, t)};
            },
            [&](const Matrix& m) -> StackEntry {
                const glm::dmat4& e = std::get<Matrix>(b).matrix;
                return Matrix{m.matrix * (1.0 - t) + e * t};
            }},
        a);
}

std::vector<StackEntry> mixed(const std::vector<StackEntry>& a, const std::vector<StackEntry>& b, double t) {
    std::size_t common = 0;
    while (common < std::min(a.size(), b.size()) && alike(a[common], b[common])) ++common;
    // What only one of them has goes first and comes last, or takes the whole time where nothing else waits for it.
    const bool going = common < a.size(), coming = common < b.size();
    const double gone = going && coming ? std::min(2.0 * t, 1.0) : t;
    const double come = going && coming ? std::max(2.0 * t - 1.0, 0.0) : t;
    std::vector<StackEntry> stack;
    for (std::size_t i = 0; i < common; ++i) stack.push_back(mixed(a[i], b[i], t));
    if (gone < 1.0)
        for (std::size_t i = common; i < a.size(); ++i) stack.push_back(partly(a[i], 1.0 - gone));
    if (come > 0.0)
        for (std::size_t i = common; i < b.size(); ++i) stack.push_back(partly(b[i], come));
    return stack;
}

}  // namespace

Scene blend(const Scene& from, const Scene& to, double t) {
    if (t >= 1.0) return to;
    t = std::max(t, 0.0);
    Scene scene = to;
    scene.camera.azimuth = mixed_azimuth(from.camera.azimuth, to.camera.azimuth, t);
    scene.camera.elevation = mixed(from.camera.elevation, to.camera.elevation, t);
    const double from_zoom = from.camera.magnification(), to_zoom = to.camera.magnification();
    scene.camera.zoom = from_zoom * std::pow(to_zoom / from_zoom, t);
    scene.camera.target.xyz = glm::mix(from.camera.target.xyz, to.camera.target.xyz, t);
    scene.light.azimuth = mixed_azimuth(from.light.azimuth, to.light.azimuth, t);
    scene.light.elevation = mixed(from.light.elevation, to.light.elevation, t);
    scene.power = mixed(from.power, to.power, t);
    scene.arrows.length = mixed(from.arrows.length, to.arrows.length, t);
    // The same formula with other parameters: the surface itself moves.
    const auto *old_formula = std::get_if<FormulaSurface>(&from.surface),
               *new_formula = std::get_if<FormulaSurface>(&scene.surface);
    if (old_formula && new_formula && old_formula->formula == new_formula->formula) {
        FormulaSurface between = *new_formula;
        for (std::size_t i = 0; i < between.parameters.size(); ++i)
            between.parameters[i] = mixed(old_formula->parameters[i], new_formula->parameters[i], t);
        scene.surface = std::move(between);
    }
    if (from.probe && to.probe) scene.probe = Point<Object>{glm::mix(from.probe->xyz, to.probe->xyz, t)};
    if (from.pinned.size() == to.pinned.size())
        for (std::size_t i = 0; i < to.pinned.size(); ++i)
            scene.pinned[i].xyz = glm::mix(from.pinned[i].xyz, to.pinned[i].xyz, t);
    if (from.stack_position || to.stack_position) {
        // Positions count entries, which must then stay; only where the stack is the same is there a way between them.
        if (from.stack == to.stack) {
            const auto count = static_cast<double>(to.stack.size());
            scene.stack_position = mixed(from.stack_position.value_or(count), to.stack_position.value_or(count), t);
        }
    } else
        scene.stack = mixed(from.stack, to.stack, t);
    return scene;
}

}  // namespace normalscope

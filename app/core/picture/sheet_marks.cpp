#include "core/picture/sheet_marks.h"

#include "core/base/decimal.h"
#include "core/frame/solids.h"
#include "core/math/sheets.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

namespace {

constexpr int kSheets = 3;
constexpr double kSpacing = 0.36, kHalf = 0.46;  ///< in radii of the object
constexpr double kHardly = 0.3;  ///< of a sheet: an axis along which a step of the object's crosses less is left out

/// What stands in one space: the object's by the identity, the world's by M.
class Stack {
public:
    Stack(Pane& pane, const Probe& probe, double radius, const FrameOptions& options, Theme theme)
        : pane_(pane),
          probe_(probe_with(probe.point, probe.normal)),
          spacing_(kSpacing * radius),
          half_(kHalf * radius),
          options_(options),
          theme_(theme) {}

    /// Two sides of each sheet lie along the probe's tangents.
    void sheets(const Transform<World, Object>& m, const glm::vec3& color) {
        for (int k = 0; k < kSheets; ++k) {
            const glm::dvec3 middle = probe_.point.xyz + k * spacing_ * probe_.normal.xyz;
            const glm::dvec3 centre = m(Point<Object>{middle}).xyz;
            const glm::dvec3 u = half_ * m(probe_.tangents[0]).xyz, v = half_ * m(probe_.tangents[1]).xyz;
            add_patch(pane_.translucent, centre, u, v, glm::vec4(color, 0.22f));
            const std::array rim{centre - u - v, centre + u - v, centre + u + v, centre - u + v};
            add_tube(pane_.solids, rim, 0.8 * pixel(centre), glm::vec4(color, 1.0f), true);
            for (std::size_t i = 0; i < rim.size(); ++i) pane_.strokes.push_back({rim[i], rim[(i + 1) % rim.size()]});
            pane_.areas.emplace_back(rim.begin(), rim.end());
        }
    }

    /// `n` as long as it comes out: of the object's unit normal, or its image.
    void steps(Point<World> from, Normal<World> n, const Transform<World, Object>& m, const glm::vec3& ink) {
        // The tangent that lies the farthest across the picture.
        const auto across = [&](Vector<Object> t) {
            const glm::dvec3 unit = glm::normalize(m(t).xyz);
            return glm::length(glm::cross(unit, glm::normalize(from.xyz - pane_.view.eye().xyz)));
        };
        const auto& [first, second] = probe_.tangents;
        const glm::dvec3 tangent = m(across(first) > across(second) ? first : second).xyz;
        step(from, {spacing_ / glm::length(tangent) * tangent}, 0.0, " along the surface",
             unless_muted(Symbol::VWorld, kTangentColor));
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(probe_.normal.xyz[axis]) < kHardly) continue;
            Vector<World> along{glm::dvec3(0.0)};
            along.xyz[axis] = n.xyz[axis] < 0.0 ? -spacing_ : spacing_;
            const double crossed = sheets_crossed(n, along, spacing_);
            step(from, along, crossed, std::string(" along ") + (along.xyz[axis] < 0.0 ? "\u2212" : "") + "xyz"[axis],
                 unless_muted(std::nullopt, ink));
        }
    }

private:
    // Of the tangent's step, or of those along the axes, beside what a lesson lets stand out.
    glm::vec3 unless_muted(std::optional<Symbol> symbol, const glm::vec3& color) const {
        const auto& stands_out = options_.marks.highlight;
        const bool tangent =
            stands_out && (stands_out->symbol == Symbol::VObject || stands_out->symbol == Symbol::VWorld);
        return !stands_out || (symbol && tangent) ? color : muted(color, theme_);
    }
    double pixel(const glm::dvec3& at) const { return options_.pixel_scale * pane_.view.world_per_pixel({at}); }

    // With a dot where it goes through a sheet.
    void step(Point<World> from, Vector<World> along, double crossed, const std::string& words,
              const glm::vec3& color) {
        const double thin = 1.5 * pixel(from.xyz);
        add_arrow(pane_.solids, from.xyz, along.xyz, thin, glm::vec4(color, 1.0f));
        for (int k = 1; k < kSheets && k <= crossed + 1e-9; ++k)
            add_ball(pane_.solids, from.xyz + k / crossed * along.xyz, 3.4 * thin, glm::vec4(color, 1.0f));
        pane_.strokes.push_back({from.xyz, from.xyz + along.xyz, ArrowProportions::kHeadRadius * thin});
        pane_.wanted.push_back(
            {from.xyz + along.xyz, (crossed == 0.0 ? "0" : with_decimals(crossed, 2)) + words, color});
    }

    Pane& pane_;
    Probe probe_;  ///< with tangents of unit length
    double spacing_, half_;
    const FrameOptions& options_;
    Theme theme_;
};

}  // namespace

void add_sheet_marks(Pane& pane, const Scene& scene, const Frame& frame,
                     const Transform<World, Object>& world_from_object, bool ghost, const FrameOptions& options) {
    if (!scene.show.sheets || !frame.probe || !frame.probe->object.has_normal()) return;
    const Probe& probe = frame.probe->object;
    const Transform<World, Object> here = world_from_object.at(probe.point);  // what it does next to the probe
    const glm::dvec3 extent = frame.surface->extent;
    Stack stack(pane, probe, std::max({extent.x, extent.y, extent.z}), options, scene.theme);
    stack.sheets(here, kInverseTransposeColor);
    if (const auto n = here(probe.normal)) stack.steps(frame.probe->point, *n, here, theme_colors(scene.theme).text);
    if (ghost) {
        const Transform<World, Object> still;
        const glm::vec3 grey = arrow_color(ArrowKind::Object, scene.theme);
        stack.sheets(still, grey);
        stack.steps(still(probe.point), *still(probe.normal), still, grey);
    }
}

}  // namespace normalscope

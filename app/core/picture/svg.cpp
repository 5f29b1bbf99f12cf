#include "core/picture/svg.h"

#include "core/base/html.h"
#include "core/frame/solids.h"
#include "core/picture/contour.h"
#include "core/picture/mesh_lines.h"
#include "core/picture/svg_words.h"
#include "core/surface/kinks.h"
#include "core/surface/surface_probe.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

/// One pane, written from back to front.
class PaneWriter {
public:
    /// `mesh`: the frame's surface, with its kinks as edges.
    PaneWriter(const Scene& scene, const Frame& frame, const Mesh& mesh, const Pane& pane, double pixel_scale)
        : frame_(frame),
          mesh_(mesh),
          pane_(pane),
          colors_(theme_colors(frame.theme)),
          m_(world_from_object(scene)),
          scale_(pixel_scale) {}

    std::string text() {
        for (const SurfaceDraw& draw : pane_.surfaces)
            if (draw.color.a >= 1.0f) surface(draw);
        for (const ArrowDraw& draw : pane_.arrows) arrows(draw);
        solids(pane_.translucent);
        solids(pane_.solids);
        for (const SurfaceDraw& draw : pane_.surfaces)
            if (draw.color.a < 1.0f) ghost(draw);
        return out_ + svg_labels(pane_, colors_, scale_);
    }

private:
    glm::dvec2 offset() const { return glm::dvec2(pane_.rect.origin); }
    glm::dvec2 at(const glm::dvec3& world) const { return offset() + glm::dvec2(pane_.view.pixel({world})); }
    bool before_eye(const glm::dvec3& world) const { return pane_.view.pixel({world}).z > 0.0; }

    // Whether the object stands between the eye and the place.
    bool hidden(const glm::dvec3& world) const {
        // What is of glass hides nothing.
        if (std::ranges::none_of(pane_.surfaces, [](const SurfaceDraw& draw) { return draw.color.a >= 1.0f; }))
            return false;
        const glm::dvec3 eye = pane_.view.eye().xyz, way = world - eye;
        const auto hit = first_hit(*frame_.surface, m_, Ray<World>{{eye}, {way}});
        return hit && hit->t < 1.0 - 2e-3;
    }

    static double turn(const PlaneTriangle& t) {
        const glm::dvec2 a = t[1] - t[0], b = t[2] - t[0];
        return a.x * b.y - a.y * b.x;
    }

    SeenMesh seen(const glm::mat4& world_from_object) const {
        const glm::dmat4 m(world_from_object);
        SeenMesh seen{mesh_, m_, pane_.view, {}, {}, {}};
        for (const glm::dvec3& position : mesh_.positions) {
            const glm::dvec4 world = m * glm::dvec4(position, 1.0);
            seen.drawn.push_back(world.w > 0.0);  // what has no image is not
            seen.world.push_back(glm::dvec3(world) / world.w);
        }
        const double sense = glm::determinant(m) < 0.0 ? 1.0 : -1.0;  // y goes down in pictures
        for (const glm::uvec3& t : mesh_.triangles) seen.front.push_back(sense * turn(flat(seen, t)) > 0.0);
        return seen;
    }
    PlaneTriangle flat(const SeenMesh& seen, const glm::uvec3& t) const {
        return {at(seen.world[t.x]), at(seen.world[t.y]), at(seen.world[t.z])};
    }
    std::vector<Loop> outline(const SeenMesh& seen) const {
        std::vector<Loop> loops;
        for (const bool front : {true, false}) {
            if (!front && mesh_.closed) break;  // the back lies behind the front
            std::vector<PlaneTriangle> triangles;
            for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
                const glm::uvec3& t = mesh_.triangles[i];
                if (seen.front[i] == front && seen.draws(t)) triangles.push_back(flat(seen, t));
            }
            for (Loop& loop : contours(triangles)) {
                // The other way round: where front and back lie over each other, neither must cut a hole into the other.
                if (!front) std::ranges::reverse(loop);
                loops.push_back(std::move(loop));
            }
        }
        return loops;
    }

    void path(const std::string& data, const std::string& attributes) {
        if (!data.empty()) out_ += "  <path " + attributes + " d=\"" + data + "\"/>\n";
    }
    std::string stroke(const glm::vec3& color, double width) const {
        return "fill=\"none\" stroke=\"" + svg_color(color) + "\" stroke-width=\"" + svg_number(width * scale_) +
               "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    }

    void surface(const SurfaceDraw& draw) {
        const SeenMesh mesh = seen(draw.world_from_object);
        path(path_data(outline(mesh)), "fill=\"" + svg_color(glm::vec3(draw.color)) + "\" fill-rule=\"nonzero\"");
        path(lines_of(mesh), stroke(colors_.text, 1.2));
    }
    void ghost(const SurfaceDraw& draw) {
        path(path_data(outline(seen(draw.world_from_object))), stroke(colors_.ghost, 1.2) + " stroke-dasharray=\"" +
                                                                   svg_number(5 * scale_) + " " +
                                                                   svg_number(4 * scale_) + "\"");
    }

    // Outline and sharp edges, as far as nothing stands before them.
    std::string lines_of(const SeenMesh& seen) const {
        const ImplicitSurface* const formula = frame_.surface->implicit.get();
        const double size = glm::length(frame_.surface->extent);
        const double lift =
            (formula ? 0.003 : 0.01) * glm::length(glm::dvec3(m_.matrix() * glm::dvec4(frame_.surface->extent, 0.0)));
        const auto object_from_world = formula ? m_.inverse() : std::nullopt;
        // Of the formula's surface itself, which its mesh is only near to.
        const auto on_surface = [&](const glm::dvec3& p) {
            if (!object_from_world) return p;
            const auto on = formula->onto_surface((*object_from_world)(Point<World>{p}), 0.05 * size);
            return on ? m_(*on).xyz : p;
        };
        std::string data;
        for (const MeshLine& line : mesh_lines(seen, formula ? Outline::ByNormals : Outline::ByFaces)) {
            const glm::dvec3 middle = on_surface(0.5 * (line.ends[0] + line.ends[1])), off = lift * line.outward;
            // An open surface is seen from both sides.
            if (!hidden(middle + off) || (!seen.mesh.closed && !hidden(middle - off)))
                data += open_path_data({at(line.ends[0]), at(line.ends[1])});
        }
        return data;
    }

    // ---- arrows on the surface: a shape of its own for each kind, as in the legend ------------------------------

    void arrows(const ArrowDraw& draw) {
        std::string shafts, heads;
        for (const Site& site : frame_.surface->arrows) {
            if (const auto ends = ends_of(draw, site))
                arrow((*ends)[0], (*ends)[1] - (*ends)[0], draw.look == ArrowLook::TwoHeads, shafts, heads);
        }
        const ArrowKind kind = kind_of(draw.color);
        std::string line = stroke(draw.color, kind == ArrowKind::Object ? 1.2 : 1.8);
        if (kind == ArrowKind::Naive)
            line += " stroke-dasharray=\"" + svg_number(3.5 * scale_) + " " + svg_number(2.5 * scale_) + "\"";
        path(shafts, line);
        if (kind == ArrowKind::Cofactor) path(shafts, stroke(colors_.background_top, 0.6));  // a double line
        if (kind == ArrowKind::Object)
            path(heads, stroke(draw.color, 1.2));
        else
            path(heads, "fill=\"" + svg_color(draw.color) + "\"");
    }
    ArrowKind kind_of(const glm::vec3& color) const {
        for (const ArrowKind kind : kArrowKinds)
            if (arrow_color(kind, frame_.theme) == color) return kind;
        return ArrowKind::Object;
    }
    void arrow(const glm::dvec3& base, const glm::dvec3& vector, bool two_heads, std::string& shafts,
               std::string& heads) const {
        constexpr int kParts = 4;
        if (!before_eye(base) || !before_eye(base + vector)) return;
        const glm::dvec2 from = at(base), to = at(base + vector), way = to - from;
        const double length = glm::length(way);
        const glm::dvec2 along = length > 1e-6 ? way / length : glm::dvec2(1.0, 0.0), across(-along.y, along.x);
        const double head = std::min(7.0 * scale_, 0.6 * length), half = 3.0 * scale_;
        if (!hidden(base + vector)) {
            const glm::dvec2 neck = to - head * along;
            heads += closed_path_data({neck - half * across, to, neck + half * across});
            const glm::dvec2 back = static_cast<double>(ArrowProportions::kToSecondHead) * head * along;
            if (two_heads)
                heads += closed_path_data({neck - back - half * across, to - back, neck - back + half * across});
        }
        // The shaft in parts, each of which is seen or not.
        int first = -1;
        for (int i = 0; i <= kParts; ++i) {
            const bool seen = i < kParts && !hidden(base + (i + 0.5) / kParts * vector);
            if (seen && first < 0) first = i;
            if (seen || first < 0) continue;
            const auto part = [&](int k) {
                return from + std::min(k / double{kParts} * length, length - head) * along;
            };
            shafts += open_path_data({part(first), part(i)});
            first = -1;
        }
    }

    // ---- what is made of triangles -----------------------------------------------------------------------------

    using WorldTriangle = std::array<glm::dvec3, 3>;

    // What touches the pane, or comes near it; false as well where it cannot be told.
    bool in_sight(const PlaneTriangle& t) const {
        const glm::dvec2 margin(40.0 * scale_), low = offset() - margin,
                                                high = offset() + glm::dvec2(pane_.rect.size) + margin;
        const glm::dvec2 from = glm::min(glm::min(t[0], t[1]), t[2]), to = glm::max(glm::max(t[0], t[1]), t[2]);
        return from.x <= high.x && from.y <= high.y && to.x >= low.x && to.y >= low.y;
    }

    // As much of it as is in sight and nothing stands before: where that is not clear from its corners, halves of it, down
    // to a few pixels, or to where doubles do not tell them apart, or to as many as a picture can show: beside the plane that a
    // projection sends to infinity there is no end of them.
    void add_seen(const WorldTriangle& t, std::vector<PlaneTriangle>& triangles) const {
        int most_halved = 20'000;
        add_seen(t, triangles, most_halved);
    }
    void add_seen(const WorldTriangle& t, std::vector<PlaneTriangle>& triangles, int& most_halved) const {
        if (!std::ranges::all_of(t, [&](const glm::dvec3& p) { return before_eye(p); })) return;
        PlaneTriangle flat{at(t[0]), at(t[1]), at(t[2])};
        if (!in_sight(flat)) return;
        std::size_t longest = 0;
        const auto length = [&](std::size_t i) { return glm::distance(flat[i], flat[(i + 1) % 3]); };
        for (const std::size_t i : {1, 2})
            if (length(i) > length(longest)) longest = i;
        const auto hides = std::ranges::count_if(t, [&](const glm::dvec3& p) { return hidden(p); });
        const double most = (hides == 0 || hides == 3 ? 40.0 : 2.0) * scale_;
        const glm::dvec3 a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3], half = 0.5 * (a + b);
        if (length(longest) > most && half != a && half != b && most_halved > 0) {
            --most_halved;
            add_seen({a, half, c}, triangles, most_halved);
            add_seen({half, b, c}, triangles, most_halved);
            return;
        }
        const double area = turn(flat);
        if (hides > 1 || std::abs(area) < 1e-3) return;
        if (area < 0.0) std::swap(flat[1], flat[2]);  // all to turn one way
        triangles.push_back(flat);
    }

    void solids(const std::vector<SolidVertex>& vertices) {
        for (std::size_t i = 0; i + 2 < vertices.size();) {
            const glm::vec4 color = vertices[i].color;
            std::vector<PlaneTriangle> triangles;
            for (; i + 2 < vertices.size() && vertices[i].color == color; i += 3) {
                const WorldTriangle t{vertices[i].position, vertices[i + 1].position, vertices[i + 2].position};
                // Of what is closed, the back would only double the front.
                const glm::dvec3 n(vertices[i].normal + vertices[i + 1].normal + vertices[i + 2].normal);
                if (glm::dot(n, pane_.view.eye().xyz - t[0]) >= 0.0) add_seen(t, triangles);
            }
            std::string fill = "fill=\"" + svg_color(glm::vec3(color)) + "\"";
            if (color.a < 1.0f) fill += " fill-opacity=\"" + svg_number(color.a) + "\"";
            path(path_data(contours(triangles)), fill);
        }
    }

    const Frame& frame_;
    const Mesh& mesh_;
    const Pane& pane_;
    ThemeColors colors_;
    Transform<World, Object> m_;
    double scale_;
    std::string out_;
};

}  // namespace

std::string svg_text(const Scene& scene, const Frame& frame, double pixel_scale, Ground ground) {
    const std::string width = std::to_string(frame.rect.size.x), height = std::to_string(frame.rect.size.y);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                      "\" viewBox=\"0 0 " + width + " " + height +
                      "\" font-family=\"'Open Sans', 'DejaVu Sans', Helvetica, Arial, sans-serif\">\n";
    if (!scene.about.empty()) out += "<title>" + html_text(scene.about) + "</title>\n";
    if (ground != Ground::Transparent) {
        const glm::vec3 color = ground == Ground::White ? glm::vec3(1.0f) : theme_colors(frame.theme).background_top;
        out += "<rect width=\"100%\" height=\"100%\" fill=\"" + svg_color(color) + "\"/>\n";
    }
    const Surface& surface = *frame.surface;
    prepare_for_many_hits(surface, world_from_object(scene));
    const Mesh mesh = surface.implicit ? cut_at_kinks(surface.mesh, *surface.implicit) : surface.mesh;
    for (std::size_t i = 0; i < frame.panes.size(); ++i) {
        const Pane& pane = frame.panes[i];
        const std::string name = "pane" + std::to_string(i + 1);
        out += "<clipPath id=\"" + name + "\"><rect x=\"" + std::to_string(pane.rect.origin.x) + "\" y=\"" +
               std::to_string(pane.rect.origin.y) + "\" width=\"" + std::to_string(pane.rect.size.x) + "\" height=\"" +
               std::to_string(pane.rect.size.y) + "\"/></clipPath>\n<g clip-path=\"url(#" + name + ")\">\n" +
               PaneWriter(scene, frame, mesh, pane, pixel_scale).text() + "</g>\n";
    }
    return out + svg_legend(frame, pixel_scale) + "</svg>\n";
}

}  // namespace normalscope

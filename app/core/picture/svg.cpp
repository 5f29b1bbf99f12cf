#include "core/picture/svg.h"

#include "core/base/html.h"
#include "core/frame/solids.h"
#include "core/picture/contour.h"
#include "core/picture/svg_words.h"
#include "core/surface/surface_probe.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace normalscope {

namespace {

/// One pane, written from back to front.
class PaneWriter {
public:
    PaneWriter(const Scene& scene, const Frame& frame, const Pane& pane, double pixel_scale)
        : frame_(frame),
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

    // The mesh in the picture, and which of its triangles turn as those at the front do.
    struct Projected {
        std::vector<glm::dvec3> world;
        std::vector<glm::dvec2> pixels;
        std::vector<bool> drawn;
        std::vector<bool> front;

        bool draws(const glm::uvec3& t) const { return drawn[t.x] && drawn[t.y] && drawn[t.z]; }
    };
    Projected projected(const glm::mat4& world_from_object) const {
        const Mesh& mesh = frame_.surface->mesh;
        const glm::dmat4 m(world_from_object);
        Projected p;
        for (const glm::dvec3& position : mesh.positions) {
            const glm::dvec4 world = m * glm::dvec4(position, 1.0);
            p.drawn.push_back(world.w > 0.0);  // what has no image is not
            p.world.push_back(glm::dvec3(world) / world.w);
            p.pixels.push_back(at(p.world.back()));
        }
        const double sense = glm::determinant(m) < 0.0 ? 1.0 : -1.0;  // y goes down in pictures
        for (const glm::uvec3& t : mesh.triangles)
            p.front.push_back(sense * turn({p.pixels[t.x], p.pixels[t.y], p.pixels[t.z]}) > 0.0);
        return p;
    }
    std::vector<Loop> outline(const Projected& p) const {
        const Mesh& mesh = frame_.surface->mesh;
        std::vector<Loop> loops;
        for (const bool front : {true, false}) {
            if (!front && mesh.closed) break;  // the back lies behind the front
            std::vector<PlaneTriangle> triangles;
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
                const glm::uvec3& t = mesh.triangles[i];
                if (p.front[i] == front && p.draws(t))
                    triangles.push_back({p.pixels[t.x], p.pixels[t.y], p.pixels[t.z]});
            }
            for (Loop& loop : contours(triangles)) {
                // The other way round: where front and back lie over each other, neither shall cut a hole into the other.
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
        const Projected p = projected(draw.world_from_object);
        path(path_data(outline(p)), "fill=\"" + svg_color(glm::vec3(draw.color)) + "\" fill-rule=\"nonzero\"");
        path(lines_of(p), stroke(colors_.text, 1.2));
    }
    void ghost(const SurfaceDraw& draw) {
        path(path_data(outline(projected(draw.world_from_object))),
             stroke(colors_.ghost, 1.2) + " stroke-dasharray=\"" + svg_number(5 * scale_) + " " +
                 svg_number(4 * scale_) + "\"");
    }

    // Outline and sharp edges, as far as nothing stands before them.
    std::string lines_of(const Projected& p) const {
        struct Edge {
            glm::dvec3 normal{0.0};  ///< of the first triangle
            int fronts = 0, count = 0;
            bool sharp = false;
            std::size_t a = 0, b = 0;
        };
        const Mesh& mesh = frame_.surface->mesh;
        using Key = std::array<std::int64_t, 3>;
        const auto key = [](const glm::dvec3& v) {
            return Key{std::llround(v.x * 1e6), std::llround(v.y * 1e6), std::llround(v.z * 1e6)};
        };
        std::map<std::pair<Key, Key>, Edge> edges;  // by place: a cube's faces have vertices of their own
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            if (!p.draws(t)) continue;
            const glm::dvec3 n = glm::cross(p.world[t.y] - p.world[t.x], p.world[t.z] - p.world[t.x]);
            if (!(glm::length(n) > 0.0)) continue;
            for (int k = 0; k < 3; ++k) {
                const std::size_t a = t[k], b = t[(k + 1) % 3];
                auto ends = std::pair(key(mesh.positions[a]), key(mesh.positions[b]));
                if (ends.second < ends.first) std::swap(ends.first, ends.second);
                if (ends.first == ends.second) continue;
                Edge& edge = edges[ends];
                if (edge.count++ == 0)
                    edge.normal = glm::normalize(n), edge.a = a, edge.b = b;
                else
                    edge.sharp |= glm::dot(edge.normal, glm::normalize(n)) < 0.82;  // more than 35°
                edge.fronts += p.front[i] ? 1 : 0;
            }
        }
        std::string data;
        const double lift = 0.01 * glm::length(glm::dvec3(m_.matrix() * glm::dvec4(frame_.surface->extent, 0.0)));
        for (const auto& [ends, edge] : edges) {
            const bool contour = edge.count == 1 || (edge.fronts > 0 && edge.fronts < edge.count);
            if (!contour && !(edge.sharp && edge.fronts > 0)) continue;
            const glm::dvec3 middle = 0.5 * (p.world[edge.a] + p.world[edge.b]);
            const auto outward = m_(Point<Object>{mesh.positions[edge.a]}, Normal<Object>{mesh.normals[edge.a]});
            const glm::dvec3 off =
                outward && glm::length(outward->xyz) > 0.0 ? lift * glm::normalize(outward->xyz) : glm::dvec3(0.0);
            if (!hidden(middle + off)) data += open_path_data({p.pixels[edge.a], p.pixels[edge.b]});
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

    void solids(const std::vector<SolidVertex>& vertices) {
        for (std::size_t i = 0; i + 2 < vertices.size();) {
            const glm::vec4 color = vertices[i].color;
            std::vector<PlaneTriangle> triangles;
            for (; i + 2 < vertices.size() && vertices[i].color == color; i += 3) {
                const glm::dvec3 a(vertices[i].position), b(vertices[i + 1].position), c(vertices[i + 2].position);
                if (!before_eye(a) || !before_eye(b) || !before_eye(c) || hidden((a + b + c) / 3.0)) continue;
                PlaneTriangle t{at(a), at(b), at(c)};
                const double area = turn(t);
                if (std::abs(area) < 1e-3) continue;
                // All to turn one way. Of what is closed, the back would only double the front.
                if (area < 0.0) {
                    if (glm::length(vertices[i].normal) > 0.0f) {
                        const glm::dvec3 n(vertices[i].normal + vertices[i + 1].normal + vertices[i + 2].normal);
                        if (glm::dot(n, pane_.view.eye().xyz - a) < 0.0) continue;
                    }
                    std::swap(t[1], t[2]);
                }
                triangles.push_back(t);
            }
            std::string fill = "fill=\"" + svg_color(glm::vec3(color)) + "\"";
            if (color.a < 1.0f) fill += " fill-opacity=\"" + svg_number(color.a) + "\"";
            path(path_data(contours(triangles)), fill);
        }
    }

    const Frame& frame_;
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
    for (std::size_t i = 0; i < frame.panes.size(); ++i) {
        const Pane& pane = frame.panes[i];
        const std::string name = "pane" + std::to_string(i + 1);
        out += "<clipPath id=\"" + name + "\"><rect x=\"" + std::to_string(pane.rect.origin.x) + "\" y=\"" +
               std::to_string(pane.rect.origin.y) + "\" width=\"" + std::to_string(pane.rect.size.x) + "\" height=\"" +
               std::to_string(pane.rect.size.y) + "\"/></clipPath>\n<g clip-path=\"url(#" + name + ")\">\n" +
               PaneWriter(scene, frame, pane, pixel_scale).text() + "</g>\n";
    }
    return out + svg_legend(frame, pixel_scale) + "</svg>\n";
}

}  // namespace normalscope

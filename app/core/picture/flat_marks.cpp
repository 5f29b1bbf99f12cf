#include "core/picture/flat_marks.h"

#include "core/frame/axis_handles.h"
#include "core/frame/drawn_arrows.h"
#include "core/frame/label_room.h"
#include "core/picture/flat_probe_marks.h"
#include "core/picture/pinned_marks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace normalscope {

namespace {

class Marks {
public:
    Marks(Pane& pane, const Scene& scene, const Frame& frame, const Transform<World, Object>& m,
          const FrameOptions& options)
        : pane_(pane),
          scene_(scene),
          frame_(frame),
          m_(m),
          options_(options),
          plane_(frame.flat->plane),
          cut_(*frame.flat->cut),
          board_(pane, plane_, options.pixel_scale),
          colors_(theme_colors(scene.theme)),
          paper_(glm::mix(colors_.background_top, colors_.background_bottom, 0.5f)),
          ghost_(scene.show.ghost && m.matrix() != glm::dmat4(1.0)) {}

    void add() {
        if (scene_.show.grid) graph_paper();
        inside();
        if (scene_.show.axes) axes();
        curves();
        arrows();
        add_flat_probe_marks(pane_, scene_, frame_, board_, options_);
        for (std::size_t i = 0; i < frame_.pinned.size(); ++i) {
            if (!frame_.pinned[i]) continue;
            const glm::dvec2 at = plane_.place(frame_.pinned[i]->point);
            board_.disc(at, 4.5, colors_.text, kProbePoint);
            pane_.wanted.push_back({plane_.at(at).xyz, std::to_string(i + 1), colors_.text});
        }
        for (const WantedLabel& end : ends_) pane_.wanted.push_back(end);
    }

private:
    // Lines a unit apart, or so many units that they do not crowd.
    void graph_paper() {
        constexpr double kNearest = 36.0;  // logical pixels
        const double pixel = board_.pixel();
        const double step = std::pow(10.0, std::max(0.0, std::ceil(std::log10(kNearest * pixel))));
        const glm::dvec2 half = 0.5 / static_cast<double>(options_.pixel_scale) * pixel * glm::dvec2(pane_.rect.size),
                         middle = plane_.place(pane_.view.eye());
        const Pen pen{1.0, glm::mix(paper_, colors_.grid, 0.28f), kPaperLines};
        for (glm::length_t k = 0; k < 2; ++k) {
            const double first = std::ceil((middle[k] - half[k]) / step), last = (middle[k] + half[k]) / step;
            for (double i = first; i <= last && i < first + 400.0; ++i) {
                glm::dvec2 a = middle - half, b = middle + half;
                a[k] = b[k] = i * step;
                board_.line(std::array{a, b}, pen);
            }
        }
    }

    void inside() {
        const glm::vec3 fill = glm::mix(paper_, colors_.surface, is_dark(scene_.theme) ? 0.22f : 0.6f);
        for (const std::array<glm::dvec2, 4>& part : cut_.inside) {
            std::array<glm::dvec2, 4> corners;
            bool all = true;
            for (std::size_t k = 0; k < 4; ++k) {
                const Point<Object> p{{part[k], 0.0}};
                all = all && m_.reaches(p);
                corners[k] = plane_.place(m_(p));
            }
            if (all) board_.polygon(corners, fill, kInside);
        }
    }

    void axes() {
        for (const AxisHandle& handle : handles_in_view(scene_, frame_.surface->extent, pane_.view)) {
            const glm::vec3 color = kAxisColors[static_cast<std::size_t>(handle.axis)];
            const bool hot = options_.hot_axis == handle.axis;
            const glm::dvec2 from = plane_.place(handle.origin), to = plane_.place(handle.knob());
            board_.line(std::array{from, to}, {1.6, glm::mix(paper_, color, 0.75f), kAxisLines});
            const glm::dvec2 way = (handle.factor < 0.0 ? -1.0 : 1.0) * glm::normalize(plane_.part(handle.unit.xyz)),
                             up(-way.y, way.x);
            const double half = (hot ? 8.0 : 6.0) * board_.pixel();
            if (options_.handles)
                board_.polygon(std::array{to - half * (way + up), to + half * (way - up), to + half * (way + up),
                                          to - half * (way - up)},
                               hot ? glm::mix(color, glm::vec3(1.0f), 0.35f) : color, kHandles);
            const glm::dvec3 end = plane_.at(to + half * way).xyz;
            ends_.push_back({end, std::string(1, "xyz"[handle.axis]), color});
            pane_.strokes.push_back({plane_.at(from).xyz, end});
        }
    }

    struct Line {
        std::vector<glm::dvec2> points;
        bool closed = false;
    };
    void draw(const Line& line, const Pen& pen) {
        line.closed ? board_.loop(line.points, pen) : board_.line(line.points, pen);
    }

    // All of them before, then all after: what is drawn later lies above in an SVG.
    void curves() {
        if (ghost_)
            for (const Curve& curve : cut_.curves) {
                Line line{{}, curve.closed};
                for (const Point<Object>& p : points_of(curve)) line.points.emplace_back(p.xyz);
                draw(line, {1.8, colors_.ghost, kGhostCurve, 6.0});
            }
        for (const Curve& curve : cut_.curves)
            for (const Line& line : images_of(curve)) draw(line, {3.2, colors_.text, kCurve});
    }

    static std::vector<Point<Object>> points_of(const Curve& curve) {
        std::vector<Point<Object>> points;
        for (const CurvePiece& piece : curve.pieces) points.push_back(piece.from.point);
        if (!curve.closed) points.push_back(curve.pieces.back().to.point);
        return points;
    }

    // In parts, where M sends some of it to infinity or beyond: that is not there.
    std::vector<Line> images_of(const Curve& curve) const {
        std::vector<Line> lines{{{}, curve.closed}};
        for (const Point<Object>& p : points_of(curve)) {
            if (m_.reaches(p)) {
                lines.back().points.push_back(plane_.place(m_(p)));
                continue;
            }
            lines.front().closed = false;
            lines.emplace_back();
        }
        return lines;
    }

    void arrows() {
        if (scene_.arrows.limit == 0) return;
        const std::vector<Site> sites =
            sites_along(cut_, std::max(std::sqrt(frame_.surface->area / scene_.arrows.limit), 1e-3 * cut_.length));
        const std::vector<ArrowKind> kinds = drawn_arrows(scene_, m_, pane_.rule);
        int layer = kQuietArrows;
        for (const ArrowKind kind :
             {ArrowKind::Object, ArrowKind::InverseTranspose, ArrowKind::Cofactor, ArrowKind::Naive}) {
            if (std::ranges::count(kinds, kind) == 0 || (kind == ArrowKind::Object && !ghost_)) continue;
            const Pen pen{kind == ArrowKind::Object ? 1.3 : 2.0, arrow_color(kind, scene_.theme), layer};
            layer += kind == ArrowKind::Object ? 2 : 1;
            if (kind == ArrowKind::Object) {
                for (const Site& site : sites)
                    arrow(glm::dvec2(site.point.xyz), glm::dvec2(site.normal.xyz), pen, kind);
            } else if (const auto map =
                           normal_map(scene_, m_, kRules[static_cast<std::size_t>(kind) - 1], options_.right_power)) {
                for (const Site& site : sites)
                    if (m_.reaches(site.point))
                        arrow(plane_.place(m_(site.point)), plane_.part((*map)(site.normal).xyz), pen, kind);
            }
        }
    }

    void arrow(glm::dvec2 base, glm::dvec2 way, const Pen& pen, ArrowKind kind) {
        const double length = 2.0 * scene_.arrows.length * (kind == ArrowKind::Object ? 1.0 : options_.unit);
        if (!(glm::length(way) > 1e-9)) return;
        if (frame_.probe && scene_.show.probe) {  // the probe's own arrows stand there
            const glm::dvec2 probe = kind == ArrowKind::Object ? glm::dvec2(frame_.probe->object.point.xyz)
                                                               : plane_.place(frame_.probe->point);
            if (glm::distance(probe, base) < 0.75 * flat_probe_length(board_, scene_, options_)) return;
        }
        const glm::dvec2 vector = length * glm::normalize(way);
        board_.arrow(base, vector, pen, arrow_look(kind), paper_);
        pane_.strokes.push_back({plane_.at(base).xyz, plane_.at(base + vector).xyz, 1.7 * pen.width * board_.pixel()});
    }

    Pane& pane_;
    const Scene& scene_;
    const Frame& frame_;
    const Transform<World, Object>& m_;
    const FrameOptions& options_;
    const FlatPlane& plane_;
    const FlatCut& cut_;
    FlatBoard board_;
    ThemeColors colors_;
    glm::vec3 paper_;
    bool ghost_;
    std::vector<WantedLabel> ends_;  ///< of the axes
};

// As many lines as it takes for none to be wider than `most`.
std::vector<std::string> lines_of(const std::string& sentence, const LabelRoom& room, double most) {
    std::vector<std::string> lines{""};
    std::istringstream words(sentence);
    for (std::string word; words >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (2.0 * room.half_size(longer, Label::Role::Side).x > most && !lines.back().empty())
            lines.push_back(word);
        else
            lines.back() = longer;
    }
    return lines;
}

}  // namespace

void add_flat_view(Frame& frame, const Scene& scene, const Transform<World, Object>& m, const FrameOptions& options) {
    const Surface& surface = *frame.surface;
    const std::shared_ptr<const FlatCut> cut =
        options.flat_cut ? options.flat_cut : std::make_shared<const FlatCut>(flat_cut(surface));
    frame.flat = flat_view(cut, m);
    Pane& pane = frame.panes.front();
    pane.view = CameraView(frame.flat->plane.straight_on(scene.camera), pane.rect.size);
    std::optional<Probe> probe =
        scene.probe ? nearest_on_cut(surface, *cut, *scene.probe, scene.borrow) : usual_on_cut(surface, *cut);
    if (probe && !m.reaches(probe->point)) probe.reset();
    if (probe) frame.probe = in_world(*probe, m, scene, options.right_power);
    if (probe && probe->singular) frame.singular = singular_point(*surface.implicit, probe->point, scene.borrow);
    if (scene.ray) frame.ray = ray_steps(scene, surface, m, CameraView(scene.camera, pane.rect.size));
    frame.pinned = pinned_probes(scene, surface, m, options.right_power, cut.get());
    judge(*frame.flat, scene, frame.probe, m, options.right_power);
    Marks(pane, scene, frame, m, options).add();
}

void end_flat_view(Frame& frame, const FrameOptions& options) {
    frame.color_key.reset();
    frame.notes = frame.surface->mesh.notes;
    if (!frame.flat || frame.flat->note.empty()) return;
    Pane& pane = frame.panes.front();
    LabelRoom room(pane, options.pixel_scale);
    const double scale = options.pixel_scale, row = 24.0 * scale, margin = 14.0 * scale;
    double beside = 0.0, above = 0.0;
    for (const LegendEntry& entry : frame.legend) {
        beside = std::max(beside, 80.0 * scale + 2.0 * room.half_size(entry.text, Label::Role::Level).x);
        above += 22.0 * scale;
    }
    const double width = pane.rect.size.x, most = width - 2.0 * margin;
    double x = 0.5 * width, bottom = pane.rect.size.y - margin;
    const double whole = 2.0 * room.half_size(frame.flat->note, Label::Role::Side).x;
    if (beside + whole + margin <= width)
        x = std::max(x, beside + 0.5 * whole);
    else
        bottom -= above + 2.0 * margin;
    const std::vector<std::string> lines = lines_of(frame.flat->note, room, most);
    for (std::size_t i = 0; i < lines.size(); ++i)
        room.put_at({x, bottom - row * (static_cast<double>(lines.size() - i) - 0.5)}, lines[i], Label::Role::Side,
                    theme_colors(frame.theme).text);
}

}  // namespace normalscope

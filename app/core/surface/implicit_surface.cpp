#include "core/surface/implicit_surface.h"

#include "core/base/error.h"
#include "core/program/compile.h"
#include "core/program/single.h"
#include "core/program/zero_crossing.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace normalscope {

namespace {

constexpr int kRegionDepth = 4;  // 16 cells a side
constexpr int kMostDegreeOnGpu = 60;
constexpr int kTrialPoints = 16;       // a side
constexpr int kMostSteps = 200;        // to a root: enough for one of multiplicity 8
constexpr int kMostShrinks = 24;       // of the region
constexpr double kBeside = 1e-9;       // of the bound
constexpr double kAtAKink = 1e-11;     // of the bound
constexpr double kOther = 1e-3;        // by so much differ unit gradients at a kink
constexpr double kAround = 0.02;       // of the bound
constexpr double kHalfPixel = 1.5e-3;  // of the bound
constexpr int kMostWrong = 3;          // of some thousand points
constexpr double kSquareable = 1e150;
constexpr double kInfinite = formulas::kInfinity;

// What is left of the cube when the parts without a zero are left out, halved so many times.
void add_where_zero(const ImplicitSurface& surface, const formulas::Box& box, int depth, bool first, double ball,
                    std::optional<formulas::Box>& found) {
    if (ball > 0.0) {  // the box's point nearest to the middle
        const glm::dvec3 nearest = glm::max(glm::max(box.low, -box.high), 0.0);
        if (glm::length(nearest) > ball) return;
    }
    // A box within what is found already changes nothing.
    if (found && glm::all(glm::lessThanEqual(found->low, box.low)) &&
        glm::all(glm::greaterThanEqual(found->high, box.high)))
        return;
    const formulas::Interval f = formulas::value(surface.program(), box);
    if (f.defined == formulas::Interval::Defined::Nowhere || !f.contains(0.0)) return;
    if (depth == 0) {
        found = found ? formulas::Box{glm::min(found->low, box.low), glm::max(found->high, box.high)} : box;
        return;
    }
    // Off the middle at first: planes of symmetry would lie on the cells' faces and double what is found.
    const double at = first ? 0.4871 : 0.5;
    const glm::dvec3 middle = glm::mix(box.low, box.high, at);
    for (int k = 0; k < 8; ++k) {
        const glm::bvec3 upper(k & 1, k & 2, k & 4);
        add_where_zero(surface, {glm::mix(box.low, middle, upper), glm::mix(middle, box.high, upper)}, depth - 1, false,
                       ball, found);
    }
}

// max(0, g) is 0 wherever g < 0, and so is what underflows.
std::optional<glm::dvec3> solid_of_zeros(const ImplicitSurface& surface) {
    const double bound = surface.source().bound;
    const std::vector<glm::dvec3> points = surface.points_throughout(kTrialPoints);
    std::vector<double> values(points.size());
    formulas::values(surface.program(), points, values);
    if (std::ranges::any_of(values, [](double f) { return f < 0.0; }) &&
        std::ranges::any_of(values, [](double f) { return f > 0.0; }))
        return std::nullopt;
    const auto zero_around = [&](const glm::dvec3& p) {
        for (glm::length_t k = 0; k < 6; ++k) {
            glm::dvec3 q = p;
            q[k / 2] += (k % 2 == 0 ? 1e-3 : -1e-3) * bound;
            if (surface.at({q}).value != 0.0) return false;
        }
        return true;
    };
    std::optional<glm::dvec3> middlemost;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (values[i] == 0.0 && (!middlemost || glm::length(points[i]) < glm::length(*middlemost)) &&
            zero_around(points[i]))
            middlemost = points[i];
    return middlemost;
}

}  // namespace

ImplicitSurface::ImplicitSurface(const FormulaSurface& source)
    : source_(source), formula_(std::make_shared<const formulas::Formula>(formulas::read(source.formula))) {
    auto tame = formulas::tamed(*formula_);
    tame_ = tame ? std::make_shared<const formulas::Formula>(std::move(*tame)) : formula_;
    const formulas::Program unset = formulas::compile(tame_->graph, tame_->f, std::nullopt);
    glsl_ = std::make_shared<const formulas::Glsl>(formulas::to_glsl(unset));
    degree_ = formulas::polynomial_degree(unset, kMostDegreeOnGpu);
    program_ = formulas::compile(tame_->graph, tame_->f, source.parameters);
    written_ = formulas::compile(formula_->graph, formula_->f, source.parameters);
    tracer_.emplace(program_);
    const formulas::Box all{glm::dvec3(-source.bound), glm::dvec3(source.bound)};
    const formulas::Interval f = formulas::value(program_, all);
    zero_everywhere_ = f.low == 0.0 && f.high == 0.0;
    if (!zero_everywhere_)
        add_where_zero(*this, all, kRegionDepth, true, source.clip == Clip::Ball ? ball() : 0.0, region_);
    if (!region_) return;
    if (!degree_) zero_throughout_ = solid_of_zeros(*this);
    if (zero_throughout_) {
        region_.reset();
        return;
    }
    // Room for what rounds differently on the graphics processor.
    const glm::dvec3 slack(1e-4 * source.bound);
    region_ = formulas::Box{glm::max(region_->low - slack, all.low), glm::min(region_->high + slack, all.high)};
}

void ImplicitSurface::check_floats(const Mesh& mesh) {
    // Half a pixel or so, and little against a small surface.
    glm::dvec3 low(kInfinite), high(-kInfinite);
    for (const glm::dvec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const double beside = std::min(kHalfPixel * source_.bound, 0.02 * glm::length(high - low));
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (const double side : {beside, -beside}) points.push_back(mesh.positions[i] + side * mesh.normals[i]);
    std::vector<double> exact(points.size()), rounded(points.size());
    formulas::values(program_, points, exact);
    formulas::values_in_floats(program_, points, rounded);
    int wrong = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double outward = i % 2 == 0 ? 1.0 : -1.0;
        wrong += exact[i] * outward > 0.0 && !(rounded[i] * outward > 0.0) ? 1 : 0;
    }
    if (wrong <= kMostWrong) return;
    const formulas::Program unset = formulas::compile(tame_->graph, tame_->f, std::nullopt);
    double_glsl_ = std::make_shared<const formulas::Glsl>(formulas::to_glsl(unset, formulas::Precision::Double));
}

std::optional<formulas::Box> ImplicitSurface::close_region() const {
    std::optional<formulas::Box> box = region_;
    for (int i = 0; i < kMostShrinks && box; ++i) {
        std::optional<formulas::Box> closer;
        add_where_zero(*this, *box, kRegionDepth, true, source_.clip == Clip::Ball ? ball() : 0.0, closer);
        if (!closer) return std::nullopt;
        const glm::dvec3 before = box->high - box->low, after = closer->high - closer->low;
        box = closer;
        if (glm::all(glm::greaterThan(after, 0.9 * before))) break;
    }
    return box;
}

formulas::Sample ImplicitSurface::at(Point<Object> p) const {
    formulas::Sample s = formulas::sample(program_, p.xyz);
    const glm::dvec3 size = glm::abs(s.gradient);
    if (const double largest = std::max({size.x, size.y, size.z}); largest > kSquareable && std::isfinite(largest)) {
        s.value /= largest;
        s.gradient /= largest;
    }
    return s;
}

bool ImplicitSurface::is_kink(Point<Object> p) const {
    const double beside = kAtAKink * source_.bound;
    std::optional<glm::dvec3> first;
    for (glm::length_t i = 0; i < 3; ++i)
        for (const double side : {-beside, beside}) {
            Point<Object> q = p;
            q.xyz[i] += side;
            const glm::dvec3 direction = glm::normalize(at(q).gradient);
            if (!std::isfinite(direction.x + direction.y + direction.z)) continue;
            if (!first) first = direction;
            if (glm::distance(*first, direction) > kOther) return true;
        }
    return false;
}

formulas::Sample ImplicitSurface::written_at(Point<Object> p) const {
    formulas::Sample sample = formulas::sample(written_, p.xyz);
    if (sample.gradient != glm::dvec3(0.0) && is_kink(p)) sample.gradient = glm::dvec3(formulas::real::kNaN);
    return sample;
}

bool ImplicitSurface::lies_on(const glm::dvec3& p) const {
    const double f = formulas::value(program_, p);
    if (f == 0.0 && !formulas::may_jump(program_)) return true;
    const auto largest_at = [&](double distance) {
        double largest = 0.0;
        for (glm::length_t k = 0; k < 6; ++k) {
            glm::dvec3 q = p;
            q[k / 2] += (k % 2 == 0 ? distance : -distance) * source_.bound;
            const double there = std::abs(formulas::value(program_, q));
            if (std::isfinite(there)) largest = std::max(largest, there);
        }
        return largest;
    };
    const double around = largest_at(kAround);
    // sign(x) is 0 at x = 0, and 1 as near to it as one likes.
    if (f == 0.0) return largest_at(kBeside) <= 0.5 * around;
    const formulas::Sample s = at({p});
    const double slope = glm::length(s.gradient);
    return std::abs(f) <= 1e-9 * around && (!std::isfinite(slope) || std::abs(s.value) <= 1e-9 * slope * source_.bound);
}

bool ImplicitSurface::inside_clip(const glm::dvec3& p) const {
    return source_.clip == Clip::Ball ? glm::dot(p, p) <= ball() * ball()
                                      : glm::all(glm::lessThanEqual(glm::abs(p), glm::dvec3(source_.bound)));
}

std::vector<glm::dvec3> ImplicitSurface::points_throughout(int a_side) const {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < a_side * a_side * a_side; ++i) {
        const glm::dvec3 cell(i % a_side, i / a_side % a_side, i / a_side / a_side);
        const glm::dvec3 p = source_.bound * (2.0 / a_side * (cell + glm::dvec3(0.47, 0.53, 0.51)) - glm::dvec3(1.0));
        if (inside_clip(p)) points.push_back(p);
    }
    return points;
}

std::optional<std::array<double, 2>> ImplicitSurface::clipped(const Ray<Object>& ray) const {
    if (!region_) return std::nullopt;
    const glm::dvec3 &o = ray.origin.xyz, &d = ray.direction.xyz;
    // Slabs: where d is 0 the quotients are infinite, with the right signs unless o lies on the face itself.
    const glm::dvec3 a = (region_->low - o) / d, b = (region_->high - o) / d;
    const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
    double from = 0.0, to = formulas::kInfinity;
    for (glm::length_t i = 0; i < 3; ++i) {
        if (d[i] == 0.0 && (o[i] < region_->low[i] || o[i] > region_->high[i])) return std::nullopt;
        if (d[i] == 0.0) continue;
        from = std::max(from, in[i]);
        to = std::min(to, out[i]);
    }
    if (source_.clip == Clip::Ball) {
        const double dd = glm::dot(d, d), middle = -glm::dot(o, d) / dd;
        const glm::dvec3 nearest = o + middle * d;
        const double inside = ball() * ball() - glm::dot(nearest, nearest);
        if (!(inside > 0.0)) return std::nullopt;
        const double half = std::sqrt(inside / dd);
        from = std::max(from, middle - half);
        to = std::min(to, middle + half);
    }
    if (!(from < to)) return std::nullopt;
    return std::array{from, to};
}

std::vector<formulas::Root> ImplicitSurface::hits(const Ray<Object>& ray, formulas::Wanted wanted,
                                                  formulas::Effort* effort) const {
    const auto part = clipped(ray);
    if (!part) return {};
    return tracer_->hits(ray.origin.xyz, ray.direction.xyz, (*part)[0], (*part)[1], wanted, effort);
}

std::optional<double> ImplicitSurface::first_hit(const Ray<Object>& ray, formulas::Effort* effort) const {
    const std::vector<formulas::Root> found = hits(ray, formulas::Wanted::First, effort);
    return found.empty() ? std::nullopt : std::optional(found.front().t);
}

std::optional<Point<Object>> ImplicitSurface::onto_surface(Point<Object> start, double reach) const {
    const auto verified = [&](const glm::dvec3& p) {
        return lies_on(p) ? std::optional(Point<Object>{p}) : std::nullopt;
    };
    glm::dvec3 p = start.xyz;
    for (int i = 0; i < kMostSteps; ++i) {
        const formulas::Sample s = at({p});
        if (std::isnan(s.value)) return std::nullopt;
        const double slope2 = glm::dot(s.gradient, s.gradient);
        if (s.value == 0.0) return verified(p);
        if (!(slope2 > 0.0)) return std::nullopt;
        const glm::dvec3 step = s.value / slope2 * s.gradient;
        const glm::dvec3 next = p - step;
        if (!(glm::length(next - start.xyz) <= reach)) return std::nullopt;
        if (next == p || glm::length(step) < 1e-15 * source_.bound) return verified(next);
        p = next;
    }
    // At a root of multiplicity m the steps leave 1 − 1/m of the distance; what is as near as this lies on it.
    const formulas::Sample s = at({p});
    if (std::abs(s.value) <= 1e-12 * glm::length(s.gradient) * source_.bound) return verified(p);
    return std::nullopt;
}

}  // namespace normalscope

#include "core/program/roots.h"
#include "core/program/steps.h"
#include "core/program/zero_crossing.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope::formulas {

namespace {

constexpr double kNarrowest = 1e-9;  // of the whole interval: a double root is not known any better
constexpr double kSame = 3e-7;       // of the whole interval: around a multiple root noise shows zeros this far apart
constexpr std::int64_t kMostParts = 20'000;            // for a formula that oscillates without end
constexpr std::int64_t kMostInstructions = 4'000'000;  // for one that is long as well

struct Part {
    double low, high;
};

class IntervalSearch {
public:
    IntervalSearch(const Program& program, glm::dvec3 o, glm::dvec3 d, double from, double to, Wanted wanted)
        : program_(program), o_(o), d_(d), from_(from), to_(to), whole_(to - from), wanted_(wanted) {
        parts_.push_back({from, to});
        values_.resize(program.size());
        derivatives_.resize(program.size());
    }

    std::vector<Root> run(Effort* effort) {
        const auto length = static_cast<std::int64_t>(program_.size());
        const std::int64_t most = std::min(kMostParts, kMostInstructions / std::max<std::int64_t>(length, 1));
        for (std::int64_t i = 0; i < most && !parts_.empty() && !done(); ++i) {
            if (effort && (effort->left -= length) < 0) return {};
            const Part part = parts_.back();
            parts_.pop_back();
            visit(part);
        }
        if (!done()) finish_cluster();
        return std::move(roots_);
    }

private:
    bool done() const { return wanted_ == Wanted::First && !roots_.empty(); }

    struct Bounds {
        Interval value, slope;
    };
    Bounds bounds(double low, double high) {
        const Interval t(low, high);
        std::array<Interval, 3> at;
        for (glm::length_t i = 0; i < 3; ++i) at[static_cast<std::size_t>(i)] = Interval(o_[i]) + Interval(d_[i]) * t;
        forward<Interval>(program_, at, values_);
        const Interval v = values_.back();
        if (v.defined == Interval::Defined::Nowhere || !v.contains(0.0)) return {v, {}};
        const std::array<Interval, 3> g = reverse<Interval>(program_, values_, derivatives_);
        return {v, g[0] * Interval(d_.x) + g[1] * Interval(d_.y) + g[2] * Interval(d_.z)};
    }
    std::pair<double, double> at(double t) const {
        const Sample s = sample(program_, o_ + t * d_);
        return {s.value, glm::dot(s.gradient, d_)};
    }

    void visit(Part part) {
        const auto [value, slope] = bounds(part.low, part.high);
        if (value.defined == Interval::Defined::Nowhere || !value.contains(0.0)) return;
        const double middle = part.low + 0.4871 * (part.high - part.low);
        if (value.defined == Interval::Defined::Everywhere && slope.defined == Interval::Defined::Everywhere &&
            std::isfinite(slope.width())) {
            // f(t) lies in f(middle) + f′([low, high])·(t − middle): near a zero this is much closer than f([low, high]).
            const Interval reach(part.low - middle, part.high - middle);
            if (!(bounds(middle, middle).value + slope * reach).contains(0.0)) return;
            if (!slope.contains(0.0)) return monotonic(part);
        }
        // What underflows is zero as far as doubles can tell.
        if (part.high - part.low < kNarrowest * whole_ || std::max(std::abs(value.low), std::abs(value.high)) < 1e-290)
            return add_cluster(part);
        parts_.push_back({middle, part.high});
        parts_.push_back({part.low, middle});
    }

    void monotonic(Part part) {
        const double low = at(part.low).first, high = at(part.high).first;
        const bool low_zero = bounds(part.low, part.low).value.contains(0.0),
                   high_zero = bounds(part.high, part.high).value.contains(0.0);
        if (low_zero && high_zero) return add_cluster(part);  // beside a multiple root, where signs are but noise
        if (low * high < 0.0) return add({refined([&](double t) { return at(t); }, part.low, part.high), false});
        // A root at an end is one of the next part as well; rounding must not hide it from both.
        if (low_zero || high_zero) add({low_zero ? part.low : part.high, false});
    }

    void add(Root root) {
        if (cluster_ && root.t - cluster_->high <= kSame * whole_) {
            cluster_->high = std::max(cluster_->high, root.t);
            return;
        }
        finish_cluster();
        if (!done() && (roots_.empty() || root.t - roots_.back().t > 1e-12 * whole_)) roots_.push_back(root);
    }

    void add_cluster(Part part) {
        if (cluster_ && part.low - cluster_->high <= kSame * whole_) {
            cluster_->high = part.high;
            return;
        }
        finish_cluster();
        if (done()) return;
        cluster_ = part;
        if (!roots_.empty() && part.low - roots_.back().t <= kSame * whole_) {
            cluster_->low = roots_.back().t;
            roots_.pop_back();
        }
    }

    // Too narrow to go on and still not decided: a sign change of a continuous f, a touching root, or a near miss.
    void finish_cluster() {
        if (!cluster_) return;
        const Part c = *cluster_;
        cluster_.reset();
        const double width = c.high - c.low;
        if (width > 0.5 * whole_) {
            if (bounds(c.low, c.low).value.contains(0.0))
                roots_.push_back({c.low, true});  // it runs within the surface
            return;
        }
        const double low = std::max(c.low - width, from_), high = std::min(c.high + width, to_);
        const auto [before, slope_before] = at(low);
        const auto [after, slope_after] = at(high);
        double t = 0.5 * (c.low + c.high);
        if (before * after < 0.0) {
            t = refined([&](double s) { return at(s); }, low, high);
            const Interval v = bounds(low, high).value;
            // A pole changes sign as well, and so does a jump.
            if (v.defined != Interval::Defined::Everywhere || !std::isfinite(v.width())) {
                const auto zero = zero_between(program_, o_ + low * d_, o_ + high * d_);
                if (!zero) return;
                t = low + *zero * (high - low);
            }
        } else {
            if (slope_before * slope_after < 0.0) t = least(low, high, slope_before);
            const Interval v = bounds(t, t).value;
            const double slack = 4.0 * v.width();
            if (v.defined == Interval::Defined::Nowhere || !std::isfinite(slack) || v.low - slack > 0.0 ||
                v.high + slack < 0.0)
                return;
        }
        if (roots_.empty() || t - roots_.back().t > 1e-12 * whole_) roots_.push_back({t, before * after > 0.0});
    }

    // Where f′ changes its sign.
    double least(double low, double high, double slope_low) const {
        for (int i = 0; i < 60; ++i) {
            const double t = 0.5 * (low + high);
            (at(t).second * slope_low > 0.0 ? low : high) = t;
        }
        return 0.5 * (low + high);
    }

    const Program& program_;
    glm::dvec3 o_, d_;
    double from_, to_, whole_;
    Wanted wanted_;
    std::vector<Part> parts_;
    std::vector<Interval> values_, derivatives_;
    std::optional<Part> cluster_;
    std::vector<Root> roots_;
};

}  // namespace

std::vector<Root> roots_by_intervals(const Program& program, glm::dvec3 o, glm::dvec3 d, double from, double to,
                                     Wanted wanted, Effort* effort) {
    return IntervalSearch(program, o, d, from, to, wanted).run(effort);
}

RayTracer::RayTracer(Program program) : program_(std::move(program)) {
    if (const auto degree = polynomial_degree(program_, kMostDegree)) finder_.emplace(*degree);
}

std::vector<Root> RayTracer::hits(glm::dvec3 o, glm::dvec3 d, double from, double to, Wanted wanted,
                                  Effort* effort) const {
    if (!(from < to)) return {};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    if (finder_) {
        if (const auto p = along_ray(program_, o + middle * d, half * d)) {
            std::vector<Root> roots = (*finder_)(*p, wanted);
            for (Root& r : roots) r.t = middle + half * r.t;
            return roots;
        }
    }
    return roots_by_intervals(program_, o, d, from, to, wanted, effort);
}

}  // namespace normalscope::formulas

#include "core/program/roots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace normalscope::formulas {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Not the middle: roots lie there more often than chance has it, and a root at a part's end is seen from both sides.
constexpr double kSplit = 0.4871;
constexpr double kNarrowest = 1e-13;

double binomial(int n, int k) {
    double result = 1.0;
    for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
    return std::round(result);
}

// The k-th derivative of p and the one after it, by Horner's rule.
std::pair<double, double> derivative_at(const RayPolynomial& p, int k, double t) {
    double value = 0.0, slope = 0.0;
    for (int i = p.degree; i >= k; --i) {
        double c = p.c[static_cast<std::size_t>(i)];
        for (int j = 0; j < k; ++j) c *= i - j;
        slope = slope * t + value;
        value = value * t + c;
    }
    return {value, slope};
}

struct Part {
    double low = -1.0, high = 1.0;
    std::array<double, kMostDegree + 1> b{};
};

// Where rounding hides which: all coefficients of [low, high] are as good as zero.
struct Cluster {
    double low, high;
};

class Search {
public:
    Search(const RayPolynomial& p, std::span<const double> b, Wanted wanted) : p_(p), wanted_(wanted) {
        Part whole;
        std::ranges::copy(b, whole.b.begin());
        double size = 0.0;
        for (const double v : b) size = std::max(size, std::abs(v));
        // Each of some 40 splits in a row rounds once, and the change of basis as often as there are terms.
        noise_ = p.noise + kEpsilon * (40.0 + 2.0 * p.degree) * size;
        parts_.push_back(whole);
    }

    std::vector<Root> run() {
        while (!parts_.empty() && !(wanted_ == Wanted::First && !roots_.empty())) {
            const Part part = parts_.back();
            parts_.pop_back();
            visit(part);
        }
        if (!(wanted_ == Wanted::First && !roots_.empty())) finish_cluster();
        return std::move(roots_);
    }

private:
    int sign(double v) const { return v > noise_ ? 1 : v < -noise_ ? -1 : 0; }

    void visit(const Part& part) {
        const auto n = static_cast<std::size_t>(p_.degree);
        int changes = 0, last = 0;
        bool some = false, all = true;
        for (std::size_t i = 0; i <= n; ++i) {
            const int s = sign(part.b[i]);
            some = some || s != 0;
            all = all && s != 0;
            if (s != 0 && last != 0 && s != last) ++changes;
            if (s != 0) last = s;
        }
        if (all && changes == 0) return;
        if (!some || part.high - part.low < kNarrowest) return add_cluster({part.low, part.high});

        const int left = sign(part.b[0]), right = sign(part.b[n]);
        if (changes == 1 && left * right < 0) return add_single(part.low, part.high, part.b[0], part.b[n]);
        if (left * right == 0 && monotonic(part)) {
            // At most one root, at the end that is as good as zero, if not between.
            if (part.b[0] * part.b[n] < 0.0) return add_single(part.low, part.high, part.b[0], part.b[n]);
            return add(left == 0 ? part.low : part.high, false);
        }
        split(part);
    }

    bool monotonic(const Part& part) const {
        int direction = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(p_.degree); ++i) {
            const int s = sign(0.5 * (part.b[i + 1] - part.b[i]));
            if (s == 0 || s * direction < 0) return false;
            direction = s;
        }
        return direction != 0;
    }

    // De Casteljau's algorithm; the left part is visited first.
    void split(const Part& part) {
        const auto n = static_cast<std::size_t>(p_.degree);
        Part left, right = part;
        left.low = part.low;
        left.high = right.low = part.low + kSplit * (part.high - part.low);
        for (std::size_t level = 0; level <= n; ++level) {
            left.b[level] = right.b[0];
            for (std::size_t i = 0; i + level < n; ++i) right.b[i] += kSplit * (right.b[i + 1] - right.b[i]);
        }
        parts_.push_back(right);
        parts_.push_back(left);
    }

    void add_single(double low, double high, double at_low, double at_high) {
        const auto f = [&](double t) { return derivative_at(p_, 0, t); };
        // At the very ends Horner's value may differ from Bernstein's by the noise.
        const bool apart = f(low).first * f(high).first < 0.0;
        add(apart ? refined(f, low, high) : std::abs(at_low) < std::abs(at_high) ? low : high, false);
    }

    void add(double t, bool touches) {
        finish_cluster();
        if (!roots_.empty() && std::abs(t - roots_.back().t) <= 1e-12) return;
        if (wanted_ == Wanted::First && !roots_.empty()) return;
        roots_.push_back({t, touches});
    }

    void add_cluster(Cluster c) {
        if (cluster_ && c.low <= cluster_->high) {
            cluster_->high = c.high;
            return;
        }
        finish_cluster();
        cluster_ = c;
    }

    // One root for the whole cluster: a root of multiplicity m is a single one of the derivative of order m − 1, which
    // has it to many more digits.
    void finish_cluster() {
        if (!cluster_) return;
        const Cluster c = *cluster_;
        cluster_.reset();
        const double width = c.high - c.low;
        if (width > 0.5) {  // the ray runs within the surface
            roots_.push_back({c.low, true});
            return;
        }
        const double low = std::max(c.low - width, -1.0), high = std::min(c.high + width, 1.0);
        const double before = derivative_at(p_, 0, low).first, after = derivative_at(p_, 0, high).first;
        double t = 0.5 * (c.low + c.high);
        // Taylor's terms around t, as large as the noise up to the order of the multiplicity and far smaller after it.
        int multiplicity = 1;
        double power = 1.0;
        for (int k = 1; k <= std::min(p_.degree, 6); ++k) {
            power *= (high - low) / k;
            if (std::abs(derivative_at(p_, k, t).first) * power > 0.01 * noise_) multiplicity = k;
        }
        const auto f = [&](double s) { return derivative_at(p_, multiplicity - 1, s); };
        if (f(low).first * f(high).first < 0.0) {
            const double candidate = refined(f, low, high);
            if (std::abs(derivative_at(p_, 0, candidate).first) <= 4.0 * noise_) t = candidate;
        }
        if (!roots_.empty() && std::abs(t - roots_.back().t) <= 1e-12) return;
        roots_.push_back({t, before * after > 0.0});
    }

    const RayPolynomial& p_;
    Wanted wanted_;
    double noise_ = 0.0;
    std::vector<Part> parts_;
    std::optional<Cluster> cluster_;
    std::vector<Root> roots_;
};

}  // namespace

RootFinder::RootFinder(int degree) : degree_(degree) {
    // t^k on [−1, 1]: coefficient i is the mean of the products of k out of n − i times −1 and i times 1.
    const auto n = static_cast<std::size_t>(degree) + 1;
    from_power_.resize(n * n);
    for (int i = 0; i <= degree; ++i)
        for (int k = 0; k <= degree; ++k) {
            double sum = 0.0;
            for (int j = std::max(0, k - degree + i); j <= std::min(i, k); ++j)
                sum += ((k - j) % 2 == 0 ? 1.0 : -1.0) * binomial(i, j) * binomial(degree - i, k - j);
            from_power_[static_cast<std::size_t>(i) * n + static_cast<std::size_t>(k)] = sum / binomial(degree, k);
        }
}

std::vector<double> RootFinder::bernstein(const RayPolynomial& p) const {
    const auto n = static_cast<std::size_t>(degree_) + 1;
    std::vector<double> b(n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k) b[i] += from_power_[i * n + k] * p.c[k];
    return b;
}

std::vector<Root> RootFinder::operator()(const RayPolynomial& p, Wanted wanted) const {
    RayPolynomial of_degree = p;
    of_degree.degree = degree_;
    return Search(of_degree, bernstein(p), wanted).run();
}

}  // namespace normalscope::formulas

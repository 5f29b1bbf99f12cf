// n · t over ten million normals and all rules, beside one pass that reads and writes them, on as many threads. Prints
// one line of JSON: milliseconds, medians of several turns.

#include "core/base/beside.h"
#include "core/math/normal_rules.h"
#include "core/surface/worst_dots.h"
#include "measure.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

using namespace normalscope;

namespace {

constexpr std::size_t kCount = 10'000'000;
constexpr int kTurns = 9;

double milliseconds(const std::function<void()>& work) {
    const Stopwatch watch;
    work();
    return watch.milliseconds();
}

void read_and_write(const std::vector<glm::dvec3>& from, std::vector<glm::dvec3>& to) {
    const std::size_t threads = threads_for(kCount, 1);
    const std::size_t part = (kCount + threads - 1) / threads;
    std::vector<Beside<void>> workers;
    for (std::size_t t = 0; t < threads; ++t)
        workers.push_back(beside([&, t] {
            for (std::size_t i = t * part; i < std::min((t + 1) * part, kCount); ++i) to[i] = -from[i];
        }));
}

}  // namespace

int main() {
    std::mt19937_64 random(1);
    std::normal_distribution<double> any;
    std::vector<glm::dvec3> normals(kCount), copy(kCount);
    for (glm::dvec3& n : normals) n = glm::normalize(glm::dvec3(any(random), any(random), any(random)));

    const glm::dmat3 m3(0.5, 0.1, 0.0, -0.3, 2.0, 0.2, 0.0, 0.4, 1.0);
    const NormalMatrices matrices = normal_matrices(m3);
    const auto map = [](const glm::dmat3& matrix) { return NormalMap{.matrix = glm::dmat4(matrix)}; };
    std::vector<double> pass, dots;
    std::array<std::optional<double>, 3> worst;
    for (int i = 0; i < kTurns; ++i) {
        pass.push_back(milliseconds([&] { read_and_write(normals, copy); }));
        dots.push_back(milliseconds([&] {
            worst = worst_dots(normals, {map(matrices.naive), map(*matrices.inverse_transpose), map(matrices.cofactor)},
                               m3);
        }));
    }
    std::printf("{\"pass_ms\": %.1f, \"dots_ms\": %.1f, \"worst_dot\": [%.3g, %.3g, %.3g]}\n", median(pass),
                median(dots), *worst[0], *worst[1], *worst[2]);
}

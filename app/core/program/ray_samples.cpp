#include "core/program/ray_samples.h"

#include "core/base/decimal.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope::formulas {

namespace {

using Matrix = std::vector<std::vector<double>>;

double binomial(int n, int k) {
    double result = 1.0;
    for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
    return std::round(result);
}

// Gauss and Jordan, with the largest pivot of each column.
Matrix inverted(Matrix a) {
    const std::size_t n = a.size();
    Matrix inverse(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i) inverse[i][i] = 1.0;
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < n; ++r)
            if (std::abs(a[r][c]) > std::abs(a[pivot][c])) pivot = r;
        std::swap(a[c], a[pivot]);
        std::swap(inverse[c], inverse[pivot]);
        const double p = a[c][c];
        for (std::size_t k = 0; k < n; ++k) {
            a[c][k] /= p;
            inverse[c][k] /= p;
        }
        for (std::size_t r = 0; r < n; ++r) {
            if (r == c) continue;
            const double m = a[r][c];
            for (std::size_t k = 0; k < n; ++k) {
                a[r][k] -= m * a[c][k];
                inverse[r][k] -= m * inverse[c][k];
            }
        }
    }
    return inverse;
}

std::string literal(double v, Precision precision) {
    return precision == Precision::Double ? with_exponent(v, 17) + "lf" : with_exponent(v, 9);
}

// Σ row[j] s[j], without the terms that are 0.
std::string dot(const std::vector<double>& row, Precision precision) {
    std::string sum;
    for (std::size_t j = 0; j < row.size(); ++j) {
        if (std::abs(row[j]) < 1e-13) continue;
        const std::string s = "s[" + std::to_string(j) + "]";
        sum += sum.empty() ? "" : " + ";
        sum += row[j] == 1.0 ? s : literal(row[j], precision) + " * " + s;
    }
    return sum.empty() ? "0.0" : sum;
}

}  // namespace

std::vector<double> chebyshev_points(int degree) {
    std::vector<double> points;
    for (int j = 0; j <= degree; ++j)
        points.push_back(degree == 0 ? 0.0 : 0.5 - 0.5 * std::cos(glm::pi<double>() * j / degree));
    return points;
}

Matrix bernstein_from_samples(int degree) {
    Matrix samples_from_bernstein;
    for (const double x : chebyshev_points(degree)) {
        std::vector<double>& row = samples_from_bernstein.emplace_back();
        for (int i = 0; i <= degree; ++i)
            row.push_back(binomial(degree, i) * std::pow(x, i) * std::pow(1.0 - x, degree - i));
    }
    Matrix result = inverted(samples_from_bernstein);
    // The ends are coefficients themselves.
    for (const std::size_t end : {std::size_t{0}, result.size() - 1})
        for (std::size_t j = 0; j < result.size(); ++j) result[end][j] = j == end ? 1.0 : 0.0;
    return result;
}

Matrix last_chebyshev_coefficients(int degree) {
    Matrix rows;
    for (const int k : {degree, degree - 1}) {
        std::vector<double>& row = rows.emplace_back();
        for (int j = 0; j <= degree; ++j) {
            const double end = j == 0 || j == degree ? 0.5 : 1.0;
            // The points ascend while their angles descend: the sign of an odd term does not matter here.
            row.push_back((k == degree ? 1.0 : 2.0) / degree * end * std::cos(glm::pi<double>() * j * k / degree));
        }
    }
    return rows;
}

std::string ray_samples_glsl(int degree, Precision precision) {
    const std::string size = std::to_string(degree + 1);
    std::string text = "#define DEGREE " + std::to_string(degree) + "\nconst REAL POINTS[" + size + "] = REAL[](";
    for (const double x : chebyshev_points(degree)) text += (x == 0.0 ? "" : ", ") + literal(x, precision);
    text += ");\nvoid to_bernstein(REAL s[" + size + "], out REAL b[" + size + "]) {\n";
    double largest = 0.0;
    const Matrix rows = bernstein_from_samples(degree);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += "    b[" + std::to_string(i) + "] = " + dot(rows[i], precision) + ";\n";
        double sum = 0.0;
        for (const double v : rows[i]) sum += std::abs(v);
        largest = std::max(largest, sum);
    }
    text += "}\nREAL last_terms(REAL s[" + size + "]) {\n    return ";
    const Matrix last = last_chebyshev_coefficients(degree);
    text += "abs(" + dot(last[0], precision) + ") + abs(" + dot(last[1], precision) + ");\n}\n";
    const double epsilon = precision == Precision::Double ? 1.2e-16 : 6e-8;
    return text + "const REAL ROUNDING = " + literal(epsilon * largest, precision) + ";\n";
}

}  // namespace normalscope::formulas

#include "core/math/value.h"

#include "core/base/decimal.h"
#include "core/math/normal_rules.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

bool finite(const Value& v) {
    for (std::size_t i = 0; i < v.size(); ++i)
        if (!std::isfinite(v.entries[i]) || !std::isfinite(v.terms[i]) || !std::isfinite(v.error[i])) return false;
    return true;
}

// The length of a vector says what its smallest component can be known to.
template <class V>
Value column(const V& vector) {
    Value result;
    result.rows = V::length();
    double largest = 0.0;
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(vector[r]));
    for (int r = 0; r < result.rows; ++r) {
        const auto i = static_cast<std::size_t>(r);
        result.entries[i] = vector[r];
        result.terms[i] = std::abs(vector[r]);
        result.error[i] = r < 3 ? 8.0 * kEpsilon * largest : 0.0;
    }
    return result;
}

// The block of rows and columns [0, n) of a square matrix: rounding there is relative to its own largest entries.
void judge_block(Value& m, int n, double relative) {
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            double row = 0.0, col = 0.0;
            for (int k = 0; k < n; ++k) {
                row = std::max(row, std::abs(m(r, k)));
                col = std::max(col, std::abs(m(k, c)));
            }
            m.error[m.index(r, c)] = relative * std::min(row, col);
        }
}

template <class M>
Value square(const M& matrix, int factors) {
    Value result;
    result.rows = result.columns = M::length();
    const double relative = 4.0 * kEpsilon * (1.0 + factors);
    for (int r = 0; r < result.rows; ++r)
        for (int c = 0; c < result.columns; ++c) {
            const std::size_t i = result.index(r, c);
            result.entries[i] = matrix[c][r];
            result.terms[i] = std::abs(matrix[c][r]);
        }
    judge_block(result, 3, relative);
    if (result.rows == 4)
        for (int k = 0; k < 4; ++k) {
            double translation = 0.0, bottom = 0.0;
            for (int j = 0; j < 3; ++j) {
                translation = std::max(translation, std::abs(result(j, 3)));
                bottom = std::max(bottom, std::abs(result(3, j)));
            }
            result.error[result.index(k, 3)] = relative * (k < 3 ? translation : std::abs(result(3, 3)));
            if (k < 3) result.error[result.index(3, k)] = relative * bottom;
        }
    return result;
}

}  // namespace

double Value::clean(int row, int column) const {
    const double v = (*this)(row, column);
    return std::abs(v) <= error[index(row, column)] ? 0.0 : v;
}

Value value_of(double number) {
    Value result;
    result.entries[0] = number;
    result.terms[0] = std::abs(number);
    result.error[0] = number == std::floor(number) ? 0.0 : kEpsilon * std::abs(number);
    return result;
}

Value value_of(const glm::dvec3& vector) { return column(vector); }
Value value_of(const glm::dvec4& vector) { return column(vector); }
Value value_of(const glm::dmat3& matrix, int factors) { return square(matrix, factors); }
Value value_of(const glm::dmat4& matrix, int factors) { return square(matrix, factors); }

glm::dmat3 dmat3_of(const Value& value) {
    glm::dmat3 m(0.0);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) m[c][r] = value(r, c);
    return m;
}

std::optional<Value> product(const Value& a, const Value& b) {
    if (a.columns != b.rows) return std::nullopt;
    Value result;
    result.rows = a.rows;
    result.columns = b.columns;
    for (int r = 0; r < a.rows; ++r)
        for (int c = 0; c < b.columns; ++c) {
            const std::size_t at = result.index(r, c);
            double sum = 0.0, size = 0.0, terms = 0.0, inherited = 0.0;
            for (int k = 0; k < a.columns; ++k) {
                const std::size_t i = a.index(r, k), j = b.index(k, c);
                sum += a.entries[i] * b.entries[j];
                size += std::abs(a.entries[i] * b.entries[j]);
                terms += a.terms[i] * b.terms[j];
                inherited += std::abs(a.entries[i]) * b.error[j] + a.error[i] * std::abs(b.entries[j]);
            }
            result.entries[at] = sum;
            result.terms[at] = terms;
            result.error[at] = inherited + kEpsilon * a.columns * size;
        }
    if (!finite(result)) return std::nullopt;
    return result;
}

Value transpose(const Value& a) {
    Value result = a;
    std::swap(result.rows, result.columns);
    for (int r = 0; r < a.rows; ++r)
        for (int c = 0; c < a.columns; ++c) {
            const std::size_t from = a.index(r, c), to = result.index(c, r);
            result.entries[to] = a.entries[from];
            result.error[to] = a.error[from];
            result.terms[to] = a.terms[from];
        }
    return result;
}

Value cofactor(const Value& a, std::optional<int> known_rank) {
    Value result = value_of(normal_matrices(dmat3_of(a), known_rank).cofactor, 0);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            const auto inherited = [&](int i, int j, int k, int l) {
                return std::abs(a(i, j)) * a.error[a.index(k, l)] + a.error[a.index(i, j)] * std::abs(a(k, l));
            };
            const std::size_t at = result.index(r, c);
            result.error[at] =
                2.0 * kEpsilon * std::abs(result.entries[at]) + inherited(r1, c1, r2, c2) + inherited(r1, c2, r2, c1);
        }
    return result;
}

std::optional<Value> inverse(const Value& a, std::optional<int> known_rank) {
    const NormalMatrices matrices = normal_matrices(dmat3_of(a), known_rank);
    if (!matrices.inverse_transpose) return std::nullopt;
    const Value c = cofactor(a);
    const double determinant = std::abs(matrices.determinant);
    double inherited = 0.0;  // the determinant's own error: it is a sum over the first column
    for (int r = 0; r < 3; ++r)
        inherited += std::abs(a(r, 0)) * c.error[c.index(r, 0)] +
                     (a.error[a.index(r, 0)] + 3.0 * kEpsilon * std::abs(a(r, 0))) * std::abs(c(r, 0));
    Value result = value_of(*matrices.inverse_transpose, 0);
    for (std::size_t i = 0; i < 9; ++i)
        result.error[i] = c.error[i] / determinant + result.terms[i] * (inherited / determinant + 2.0 * kEpsilon);
    if (!finite(result)) return std::nullopt;
    return transpose(result);
}

std::optional<Difference> difference(const Value& a, const Value& b) {
    if (a.rows != b.rows || a.columns != b.columns || !finite(a) || !finite(b)) return std::nullopt;
    Difference result;
    result.largest = -1.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double off = std::abs(a.entries[i] - b.entries[i]), rounding = a.error[i] + b.error[i];
        const double terms = std::max(a.terms[i], b.terms[i]);
        if (off > rounding) result.within_rounding = false;
        if (terms > 0.0) result.relative = std::max(result.relative, off / terms);
        if (off <= result.largest) continue;
        result.largest = off;
        result.rounding = rounding;
    }
    return result;
}

std::string number_text(double number, double error, int decimals) {
    if (!std::isfinite(number)) return "too large";
    if (std::abs(number) <= error || number == 0.0) return "0";
    const double size = std::abs(number);
    if (size >= 1e6 || size < 0.5 * std::pow(10.0, 1 - decimals)) {
        // 1.500e-08 is 1.5e-8
        std::string digits = with_exponent(number, decimals - 1), exponent = digits.substr(digits.find('e') + 1);
        digits.resize(digits.find('e'));
        digits.resize(digits.find_last_not_of('0') + 1);
        if (digits.ends_with('.')) digits.pop_back();
        const bool negative = exponent.front() == '-';
        exponent.erase(0, std::min(exponent.find_first_not_of("+-0"), exponent.size() - 1));
        return digits + "e" + (negative ? "-" : "") + exponent;
    }
    // Before the point as many more digits as after it fewer: large entries would push a matrix off the page.
    const int whole = size >= 100.0 ? static_cast<int>(std::log10(size)) - 1 : 0;
    std::string digits = with_decimals(number, std::max(decimals - whole, 0));
    if (digits.find('.') != std::string::npos) {
        digits.resize(digits.find_last_not_of('0') + 1);
        if (digits.ends_with('.')) digits.pop_back();
    }
    return digits;
}

std::string number_text(const Value& value, int row, int column, int decimals) {
    return number_text(value(row, column), value.error[value.index(row, column)], decimals);
}

}  // namespace normalscope

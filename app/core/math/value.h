#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <string>

namespace normalscope {

/// A number, a vector or a matrix up to 4×4 as it was computed, with what rounding has done to it. A number is 1×1, a
/// vector a column; its transpose is a row.
struct Value {
    int rows = 1, columns = 1;
    std::array<double, 16> entries{};  ///< row by row
    /// How far off each entry can be by rounding, to first order (running error analysis: Higham, Accuracy and Stability
    /// of Numerical Algorithms, section 3.3).
    std::array<double, 16> error{};
    /// The same sums with every term made positive: an entry much smaller than its terms has lost digits.
    std::array<double, 16> terms{};

    double operator()(int row, int column) const { return entries[index(row, column)]; }
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
    std::size_t size() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
    bool is_number() const { return size() == 1; }
    /// The entry as people would have it: 0 where it is no larger than its rounding error; never −0.
    double clean(int row, int column) const;
};

/// Exact, but for the last digit of what is not 0, 1 or −1.
Value value_of(double number);
/// Each component is taken to be off by rounding of the largest, as where it was made by normalising or interpolating;
/// not so the w of four.
Value value_of(const glm::dvec3& vector);
Value value_of(const glm::dvec4& vector);
/// A product of `factors` matrices. What is at most 4ε(1 + factors) of the largest entry of its row and of that of its
/// column is taken for rounding of zero; for 4×4 the translation column and the bottom row are judged by themselves.
Value value_of(const glm::dmat3& matrix, int factors = 1);
Value value_of(const glm::dmat4& matrix, int factors = 1);

glm::dmat3 dmat3_of(const Value& value);

// Empty where a shape does not fit or a number overflows.
std::optional<Value> product(const Value& a, const Value& b);
Value transpose(const Value& a);
/// Of a 3×3 matrix; `known_rank` as in normal_matrices. Empty where there is none.
std::optional<Value> inverse(const Value& a, std::optional<int> known_rank = {});
Value cofactor(const Value& a, std::optional<int> known_rank = {});

struct Difference {
    double largest = 0.0;   ///< |a − b|, of the entry where it is largest
    double rounding = 0.0;  ///< how large rounding alone could make it there
    double relative = 0.0;  ///< the largest |a − b|, relative to its terms
    bool within_rounding = true;
};
std::optional<Difference> difference(const Value& a, const Value& b);

/// The number in at most `decimals` decimals (fewer from 1000 on), or in scientific notation where these would not show it; "0" up to `error`.
std::string number_text(double number, double error = 0.0, int decimals = 4);
std::string number_text(const Value& value, int row, int column, int decimals = 4);

}  // namespace normalscope

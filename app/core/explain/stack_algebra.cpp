#include "core/explain/stack_algebra.h"

#include "core/explain/derivation.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr double kSame = 1e-12;  // entries of matrices that are the same but for rounding, relative to the largest

bool same(const glm::dmat3& a, const glm::dmat3& b) {
    return largest_entry(a - b) <= kSame * std::max(largest_entry(a), largest_entry(b));
}
// But for a factor.
bool same_direction(const glm::dmat3& a, const glm::dmat3& b) {
    const glm::dmat3 unit_a = a / largest_entry(a), unit_b = b / largest_entry(b);
    return same(unit_a, unit_b) || same(unit_a, -unit_b);
}
bool finite(const glm::dmat3& m) { return std::isfinite(largest_entry(m)) && largest_entry(m) < 1e60; }

bool is_diagonal(const glm::dmat3& m) { return m == glm::dmat3(m[0].x, 0, 0, 0, m[1].y, 0, 0, 0, m[2].z); }

std::vector<std::string> observations(const glm::dmat4& a, const NormalMatrices& matrices) {
    std::vector<std::string> result;
    const glm::dmat3 a3(a), identity(1.0), slide = a3 - identity;
    if (!is_affine(a))
        result.emplace_back("the bottom row is not 0 0 0 1: not affine, so its 3×3 part does not tell everything");
    if (!matrices.inverse_transpose) {
        result.push_back("no inverse: its rank is " + std::to_string(matrices.rank) +
                         (is_diagonal(a3) ? ", since there is no 1/0" : ", one of its stretch factors is 0"));
        return result;
    }
    const glm::dmat3& n = *matrices.inverse_transpose;
    if (a3 == identity) {
        result.emplace_back(a == glm::dmat4(1.0)
                                ? "A = I: nothing changes"
                                : "A₃ = I: the translation is in the last column only, and does not act on normals");
        return result;
    }
    if (same(n, a3))
        result.emplace_back(
            "(A⁻¹)ᵀ = A: its columns are perpendicular unit vectors, so its inverse is its transpose, and transposing "
            "that gives A again");
    else if (is_diagonal(a3))
        result.emplace_back("each factor becomes its reciprocal: (S(x, y, z)⁻¹)ᵀ = S(1/x, 1/y, 1/z)");
    else if (same(slide * slide, glm::dmat3(0.0)) || largest_entry(slide * slide) <= kSame * largest_entry(slide))
        result.emplace_back("(A⁻¹)ᵀ = I − (A − I)ᵀ: the shear is reversed, and acts on the other coordinate");
    else if (same_direction(n, a3))
        result.emplace_back("(A⁻¹)ᵀ is A but for a factor: the direction is the same, the length is not");
    if (matrices.determinant < 0.0)
        result.emplace_back("the determinant is negative: it reflects, and reverses the winding");
    return result;
}

std::optional<Value> value_if(const std::optional<glm::dmat3>& m, int factors) {
    return m && finite(*m) ? std::optional(value_of(*m, factors)) : std::nullopt;
}

}  // namespace

std::vector<EntryAlgebra> stack_algebra(std::span<const StackEntry> stack) {
    std::vector<EntryAlgebra> result;
    glm::dmat4 m(1.0);
    std::optional<glm::dmat3> composite(glm::dmat3(1.0));
    int factors = 0;
    for (const StackEntry& entry : stack) {
        const glm::dmat4 a = matrix(entry);
        const NormalMatrices matrices = normal_matrices(glm::dmat3(a), rank(entry));
        m = a * m;
        ++factors;
        composite = composite && matrices.inverse_transpose ? std::optional(*matrices.inverse_transpose * *composite)
                                                            : std::nullopt;

        EntryAlgebra row;
        row.kind = name(entry);
        row.a = value_of(a);
        row.inverse = inverse(value_of(glm::dmat3(a)), matrices.rank);
        if (row.inverse) row.inverse_transpose = transpose(*row.inverse);
        row.observations = observations(a, matrices);
        row.product = value_of(m, factors);
        row.composite = value_if(composite, factors);
        if (finite(glm::dmat3(m))) {
            const std::optional<Value> inverted =
                inverse(value_of(glm::dmat3(m), factors), known_rank(stack.first(result.size() + 1)));
            if (inverted) row.inverted_product = transpose(*inverted);
        }
        if (row.composite && row.inverted_product) row.apart = difference(*row.composite, *row.inverted_product);
        if (row.apart) row.apart->relative = row.apart->largest / largest_entry(dmat3_of(*row.inverted_product));
        result.push_back(std::move(row));
    }
    return result;
}

bool commute(std::span<const StackEntry> stack) {
    std::vector<glm::dmat3> factors;
    for (const StackEntry& entry : stack) factors.emplace_back(matrix(entry));
    for (std::size_t i = 0; i < factors.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (!same(factors[i] * factors[k], factors[k] * factors[i])) return false;
    return true;
}

std::vector<OrderOfInverses> orders_of_inverses(std::span<const StackEntry> stack, const Transform<World, Object>& m,
                                                const std::optional<Probe>& probe) {
    const int factors = static_cast<int>(stack.size());
    const auto right = composite_of_inverse_transposes(stack),
               reversed = reversed_composite_of_inverse_transposes(stack);
    const glm::dmat3 m3(product(stack));
    const auto truth = normal_matrices(m3, known_rank(stack)).inverse_transpose;
    const auto true_normal = probe ? m(probe->point, probe->normal) : std::nullopt;
    const auto inverse_only = truth ? std::optional(glm::transpose(*truth)) : std::nullopt;

    std::vector<OrderOfInverses> result;
    const auto add = [&](std::string id, std::string formula, std::string reason, const std::optional<glm::dmat3>& by) {
        OrderOfInverses order{.id = std::move(id),
                              .formula = std::move(formula),
                              .reason = std::move(reason),
                              .matrix = value_if(by, factors)};
        if (order.matrix && truth) {
            const auto d = difference(*order.matrix, value_of(*truth, factors));
            order.is_right = m.affine() && d && d->largest <= 1e-9 * largest_entry(*truth);
        }
        if (order.matrix && true_normal && (truth || !m.affine()))
            order.degrees_off = angle_degrees(*by * probe->normal.xyz, true_normal->xyz);
        result.push_back(std::move(order));
    };
    add("right", "((AB)⁻¹)ᵀ = (A⁻¹)ᵀ (B⁻¹)ᵀ",
        "inverting reverses the order, transposing reverses it again: the original order", right);
    add("inverses-not-reversed", "(A⁻¹ B⁻¹)ᵀ = (B⁻¹)ᵀ (A⁻¹)ᵀ", "A⁻¹ B⁻¹ taken for (AB)⁻¹, which is B⁻¹ A⁻¹", reversed);
    add("transposes-not-reversed", "(B⁻¹)ᵀ (A⁻¹)ᵀ", "(XY)ᵀ taken for Xᵀ Yᵀ: the same matrix as the line above",
        reversed);
    add("neither-reversed", "(A⁻¹)ᵀ (B⁻¹)ᵀ", "the two mistakes cancel out: right, by luck", right);
    add("not-transposed", "(AB)⁻¹", "the inverse without the transpose: it leads back to object space", inverse_only);
    add("not-inverted", "(AB)ᵀ", "the transpose without the inverse", glm::transpose(m3));
    add("naive", "AB", "neither: the naive rule", m3);
    return result;
}

}  // namespace normalscope

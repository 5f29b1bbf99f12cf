#pragma once

#include "core/math/stack.h"
#include "core/math/value.h"
#include "core/surface/probe.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// One entry A of the stack, and the products up to it. What does not exist, or overflows, is empty.
struct EntryAlgebra {
    std::string kind;                        ///< "scale", …
    Value a;                                 ///< 4×4
    std::optional<Value> inverse;            ///< A3⁻¹
    std::optional<Value> inverse_transpose;  ///< (A3⁻¹)ᵀ
    std::vector<std::string> observations;   ///< what is special about A, as found in its numbers
    Value product;                           ///< 4×4: M as far as this entry
    std::optional<Value>
        composite;  ///< the product of the inverse transposes as far as this entry: nothing is inverted but single entries
    std::optional<Value> inverted_product;  ///< ((M3)⁻¹)ᵀ of the product: the composite is inverted
    std::optional<Difference> apart;        ///< of these two; relative to the largest entry
};
std::vector<EntryAlgebra> stack_algebra(std::span<const StackEntry> stack);

/// A matrix that normals might be sent through by mistake, or rightly.
struct OrderOfInverses {
    std::string id;       ///< "right", "inverses-not-reversed", …
    std::string formula;  ///< for a stack of two: "((AB)⁻¹)ᵀ = (A⁻¹)ᵀ (B⁻¹)ᵀ"
    std::string reason;
    std::optional<Value> matrix;        ///< 3×3
    std::optional<double> degrees_off;  ///< of the probe's normal, from the true one
    bool is_right = false;              ///< the true matrix, but for rounding
};
/// Whether what the entries do to vectors is the same in every order, but for rounding.
bool commute(std::span<const StackEntry> stack);
/// What comes of taking the inverses or the transposes in the wrong order, or of leaving one of them out.
/// `m` is their product: where it is not affine, none is right.
std::vector<OrderOfInverses> orders_of_inverses(std::span<const StackEntry> stack, const Transform<World, Object>& m,
                                                const std::optional<Probe>& probe);

}  // namespace normalscope

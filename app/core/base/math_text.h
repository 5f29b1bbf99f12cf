#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

struct MathPart;
using MathLine = std::vector<MathPart>;

/// A piece of a line in which mathematics is written as one types it:
///
///     M_3  n_obj  x^2  M^{-1}  M₃⁻¹    a name with what stands below and above it; letters that are raised already count
///     (M_3^{-1})^T                     the same of what is in parentheses
///     {a}/{b}   √{x}   **bold**
///     [1, 0; 0, 2]                     a matrix, row by row
///
/// A backslash before one of these signs leaves it as it is.
struct MathPart {
    enum class Kind { Words, Scripted, Parentheses, Fraction, Root, Matrix, Bold } kind = Kind::Words;
    std::string words{};
    /// Scripted: base, below, above. Parentheses, root, bold: the inside. Fraction: above and below the bar. Matrix: the
    /// entries, row by row.
    std::vector<MathLine> lines{};
    std::size_t columns = 0;  ///< of a matrix
};
/// What is not mathematics is words; nothing is an error.
MathLine read_math(std::string_view utf8);

/// One of "n_obj", "v_obj", "n_world", "v_world", "n_naive", or empty.
std::string symbol_name(const MathPart& part);
/// The words of a line that has nothing else; else empty.
std::string only_words(const MathLine& line);

/// On one line, by letters alone, as for a file's name or a screen reader: "M₃⁻¹", "a/b".
std::string plain_math(std::string_view utf8);

}  // namespace normalscope

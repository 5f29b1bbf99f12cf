#pragma once

#include "core/base/utf8.h"
#include "core/math/value.h"

#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// A block of text of equally wide lines, one of which is level with the text beside it: how mathematics is set in a
/// terminal.
struct TextBox {
    std::vector<std::string> lines{""};
    std::size_t width = 0;
    std::size_t middle = 0;  ///< the line that is level with its neighbours
};

TextBox text_box(std::string_view line);
/// A matrix or vector in brackets, its columns aligned at the decimal points; a number as itself.
TextBox matrix_box(const Value& value, int decimals = 4);
/// Side by side, their middle lines level.
TextBox beside(const TextBox& left, const TextBox& right);
TextBox beside(const std::vector<TextBox>& boxes, std::string_view gap = " ");
TextBox in_parentheses(const TextBox& box);
/// With `mark` at the top right.
TextBox superscript(const TextBox& box, std::string_view mark);

/// Breaks at spaces to lines of at most `width` columns.
std::vector<std::string> wrapped(std::string_view utf8, std::size_t width);
/// Lines with the indentation before each, a line break after each, and no spaces at their ends.
std::string indented(const std::vector<std::string>& lines, std::size_t indent);

}  // namespace normalscope

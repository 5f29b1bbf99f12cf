#include "core/explain/text_box.h"

#include <algorithm>
#include <array>

namespace normalscope {

namespace {

// A column of numbers: integer parts to the right, decimal points below one another.
std::vector<std::string> aligned(const std::vector<std::string>& numbers) {
    const auto whole = [](const std::string& n) {
        return columns(std::string_view(n).substr(0, n.find_first_of(".e")));
    };
    std::size_t before = 0, after = 0;
    for (const std::string& n : numbers) {
        before = std::max(before, whole(n));
        after = std::max(after, columns(n) - whole(n));
    }
    std::vector<std::string> result;
    for (const std::string& n : numbers)
        result.push_back(std::string(before - whole(n), ' ') +
                         padded(n, before - whole(n) == 0 ? before + after : whole(n) + after));
    return result;
}

TextBox fenced(const TextBox& box, const std::array<std::string_view, 8>& marks) {
    TextBox result{{}, box.width + 2, box.middle};
    const std::size_t n = box.lines.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t which = n == 1 ? 3 : i == 0 ? 0 : i + 1 == n ? 2 : 1;
        result.lines.push_back(std::string(marks[which]) + box.lines[i] + std::string(marks[which + 4]));
    }
    return result;
}

}  // namespace

TextBox text_box(std::string_view line) { return {{std::string(line)}, columns(line), 0}; }

TextBox matrix_box(const Value& value, int decimals) {
    if (value.is_number()) return text_box(number_text(value, 0, 0, decimals));
    std::vector<std::string> lines(static_cast<std::size_t>(value.rows));
    for (int c = 0; c < value.columns; ++c) {
        std::vector<std::string> numbers;
        for (int r = 0; r < value.rows; ++r) numbers.push_back(number_text(value, r, c, decimals));
        numbers = aligned(numbers);
        for (std::size_t r = 0; r < lines.size(); ++r) lines[r] += (c > 0 ? "  " : " ") + numbers[r];
    }
    for (std::string& line : lines) line += " ";
    return fenced({lines, columns(lines.front()), (lines.size() - 1) / 2}, {"⎡", "⎢", "⎣", "[", "⎤", "⎥", "⎦", "]"});
}

TextBox beside(const TextBox& left, const TextBox& right) {
    TextBox result{{}, left.width + right.width, std::max(left.middle, right.middle)};
    const std::size_t below = std::max(left.lines.size() - left.middle, right.lines.size() - right.middle);
    const auto line = [&](const TextBox& box, std::size_t i) {
        const std::size_t first = result.middle - box.middle;
        return i >= first && i - first < box.lines.size() ? padded(box.lines[i - first], box.width)
                                                          : std::string(box.width, ' ');
    };
    for (std::size_t i = 0; i < result.middle + below; ++i) result.lines.push_back(line(left, i) + line(right, i));
    return result;
}

TextBox beside(const std::vector<TextBox>& boxes, std::string_view gap) {
    TextBox result = boxes.front();
    for (std::size_t i = 1; i < boxes.size(); ++i) result = beside(beside(result, text_box(gap)), boxes[i]);
    return result;
}

TextBox in_parentheses(const TextBox& box) { return fenced(box, {"⎛", "⎜", "⎝", "(", "⎞", "⎟", "⎠", ")"}); }

TextBox superscript(const TextBox& box, std::string_view mark) {
    TextBox result = box;
    result.width += columns(mark);
    for (std::size_t i = 0; i < result.lines.size(); ++i)
        result.lines[i] = padded(box.lines[i] + (i == 0 ? std::string(mark) : ""), result.width);
    return result;
}

std::vector<std::string> wrapped(std::string_view utf8, std::size_t width) {
    std::vector<std::string> lines;
    std::string line;
    while (!utf8.empty()) {
        const std::size_t end = std::min(utf8.find(' '), utf8.size());
        const std::string_view word = utf8.substr(0, end);
        utf8.remove_prefix(std::min(end + 1, utf8.size()));
        if (!line.empty() && columns(line) + 1 + columns(word) > width) {
            lines.push_back(line);
            line.clear();
        }
        line += (line.empty() ? "" : " ") + std::string(word);
    }
    lines.push_back(line);
    return lines;
}

std::string indented(const std::vector<std::string>& lines, std::size_t indent) {
    std::string result;
    for (const std::string& line : lines) {
        std::string whole = std::string(indent, ' ') + line;
        whole.resize(whole.find_last_not_of(' ') + 1);
        result += whole + "\n";
    }
    return result;
}

}  // namespace normalscope

#include "cli/nearest.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace normalscope {

namespace {

// Levenshtein's distance: letters to insert, drop or replace. One row of the table at a time.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> names) {
    constexpr std::size_t kLongest = 40;  // nobody misspells longer ones, and the table grows with the square
    if (word.size() > kLongest) return std::nullopt;
    std::optional<std::string> best;
    std::size_t fewest = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& name : names)
        if (const std::size_t n = edits(word, name); n < fewest) {
            fewest = n;
            best = name;
        }
    return best;
}

}  // namespace normalscope

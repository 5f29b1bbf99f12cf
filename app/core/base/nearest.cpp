#include "core/base/nearest.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace normalscope {

namespace {

// Letters to insert, drop or replace, or neighbours to exchange: the optimal string alignment distance. A row of its table
// follows from the two before it.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            row[j + 1] = std::min({last[j] + (a[i] == b[j] ? 0 : 1), row[j] + 1, last[j + 1] + 1});
            if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
                row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
        }
        before.swap(last);
        last.swap(row);
    }
    return last.back();
}

}  // namespace

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> names) {
    constexpr std::size_t kLongest = 40;  // nobody misspells longer ones, and the table grows with the square
    constexpr std::size_t kShortestPart = 4;
    if (word.size() > kLongest) return std::nullopt;
    std::optional<std::string> best;
    // One letter is one edit from every other: it is only meant as itself, by whoever wrote it large.
    std::size_t fewest = word.size() < 2 ? 1 : std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& name : names)
        if (const std::size_t n = edits(word, name); n < fewest) {
            fewest = n;
            best = name;
        }
    if (best || word.size() < kShortestPart) return best;
    for (const std::string& name : names)
        if (name.find(word) != name.npos && (!best || name.size() < best->size())) best = name;
    return best;
}

}  // namespace normalscope

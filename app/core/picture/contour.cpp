#include "core/picture/contour.h"

#include "core/base/decimal.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace normalscope {

namespace {

using Key = std::pair<std::int64_t, std::int64_t>;

// Corners of different triangles are the same place where they are less than a thousandth of a pixel apart.
Key key(glm::dvec2 p) { return {std::llround(p.x * 1000.0), std::llround(p.y * 1000.0)}; }
glm::dvec2 place(Key k) { return {static_cast<double>(k.first) / 1000.0, static_cast<double>(k.second) / 1000.0}; }

std::string coordinate(double v) {
    std::string s = with_decimals(v, 1);
    if (s.ends_with(".0")) s.resize(s.size() - 2);
    return s == "-0" ? "0" : s;
}

std::string point(glm::dvec2 p) { return coordinate(p.x) + " " + coordinate(p.y); }

}  // namespace

std::vector<Loop> contours(const std::vector<PlaneTriangle>& triangles) {
    std::map<std::pair<Key, Key>, int> count;
    for (const PlaneTriangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Key a = key(t[i]), b = key(t[(i + 1) % 3]);
            if (a == b) continue;
            const auto back = count.find({b, a});
            if (back == count.end())
                ++count[{a, b}];
            else if (--back->second == 0)
                count.erase(back);
        }
    std::multimap<Key, Key> next;
    for (const auto& [edge, n] : count)
        for (int i = 0; i < n; ++i) next.emplace(edge.first, edge.second);
    std::vector<Loop> loops;
    while (!next.empty()) {
        Loop loop;
        const Key first = next.begin()->first;
        for (Key at = first;;) {
            const auto step = next.find(at);
            if (step == next.end()) break;  // cannot be: as many edges lead to a place as away from it
            loop.push_back(place(at));
            at = step->second;
            next.erase(step);
            if (at == first) break;
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

std::string open_path_data(const std::vector<glm::dvec2>& line) {
    std::string data;
    for (std::size_t i = 0; i < line.size(); ++i) data += (i == 0 ? "M" : "L") + point(line[i]);
    return data;
}

std::string closed_path_data(const std::vector<glm::dvec2>& line) { return open_path_data(line) + "Z"; }

std::string path_data(const std::vector<Loop>& loops) {
    std::string data;
    for (const Loop& loop : loops) data += closed_path_data(loop);
    return data;
}

}  // namespace normalscope

#pragma once

// How numbers, vectors and matrices are written wherever we write JSON for others to check: `null` for what does not
// exist, never NaN; matrices as arrays of rows.

#include "core/math/normal_rules.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace normalscope {

inline nlohmann::ordered_json json_number(double v) {
    return std::isfinite(v) ? nlohmann::ordered_json(v + 0.0) : nlohmann::ordered_json(nullptr);  // + 0.0: no "-0.0"
}

/// A GLM vector of any length.
template <class V>
nlohmann::ordered_json json_vector(const V& v) {
    auto result = nlohmann::ordered_json::array();
    for (int i = 0; i < V::length(); ++i) result.push_back(json_number(v[i]));
    return result;
}

/// An array of rows, as people write matrices; GLM holds columns.
template <class M>
nlohmann::ordered_json json_rows(const M& m) {
    auto result = nlohmann::ordered_json::array();
    for (int r = 0; r < M::col_type::length(); ++r) {
        auto row = nlohmann::ordered_json::array();
        for (int c = 0; c < M::length(); ++c) row.push_back(json_number(m[c][r]));
        result.push_back(row);
    }
    return result;
}

template <class T, class F>
nlohmann::ordered_json json_or_null(const std::optional<T>& v, F&& json) {
    return v ? nlohmann::ordered_json(json(*v)) : nlohmann::ordered_json(nullptr);
}

/// An object with one value a rule.
template <class T, class F>
nlohmann::ordered_json json_by_rule(const ByRule<T>& values, F&& json) {
    auto result = nlohmann::ordered_json::object();
    for (const Rule rule : kRules) result[std::string(name(rule))] = json(values[rule]);
    return result;
}

}  // namespace normalscope

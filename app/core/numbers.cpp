#include "core/numbers.h"

#include "core/json_text.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

Json number(double v) { return std::isfinite(v) ? Json(v + 0.0) : Json(nullptr); }  // + 0.0: no "-0.0"
Json triple(const glm::dvec3& v) { return Json::array({number(v.x), number(v.y), number(v.z)}); }

template <class T, class F>
Json or_null(const std::optional<T>& v, F&& json) {
    return v ? json(*v) : Json(nullptr);
}

// An array of rows, as people write matrices; GLM holds columns.
template <class M>
Json rows(const M& m) {
    Json result = Json::array();
    for (int r = 0; r < M::col_type::length(); ++r) {
        Json row = Json::array();
        for (int c = 0; c < M::length(); ++c) row.push_back(number(m[c][r]));
        result.push_back(row);
    }
    return result;
}

template <class T, class F>
Json by_rule(const std::array<T, 3>& values, F&& json) {
    Json result = Json::object();
    for (std::size_t i = 0; i < kRules.size(); ++i) result[std::string(name(kRules[i]))] = json(values[i]);
    return result;
}

Json probe_json(const ProbeInWorld& p) {
    const auto pair = [](const auto& tangents) { return Json::array({triple(tangents[0].xyz), triple(tangents[1].xyz)}); };
    Json j;
    j["point_object"] = triple(p.object.point.xyz);
    j["point_world"] = triple(p.point.xyz);
    j["n_object"] = triple(p.object.normal.xyz);
    j["n_world"] = by_rule(p.normals, [](const auto& n) { return or_null(n, [](const auto& v) { return triple(v.xyz); }); });
    j["tangents_object"] = pair(p.object.tangents);
    j["tangents_world"] = pair(p.tangents);
    j["dots"] = by_rule(p.dots, [](const auto& d) {
        return or_null(d, [](const auto& v) { return Json::array({number(v[0]), number(v[1])}); });
    });
    return j;
}

}  // namespace

std::string numbers_text(const Scene& scene, const Frame& frame, const Drawn& drawn) {
    const Transform<World, Object> m = world_from_object(scene);
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const auto errors = error_statistics(frame.surface->mesh, matrices);

    Json j;
    j["renderer"] = drawn.renderer;
    j["context"] = drawn.context;
    j["M"] = rows(m.matrix());
    j["determinant"] = number(matrices.determinant);
    j["rank"] = matrices.rank;
    j["condition"] = or_null(matrices.condition(), number);
    for (const Rule rule : kRules)
        j["normal_matrix"][std::string(name(rule))] = or_null(matrices.by(rule), [](const auto& n) { return rows(n); });
    j["error_degrees"]["worst"] = or_null(errors, [](const auto& e) { return number(e.worst_degrees); });
    j["error_degrees"]["mean"] = or_null(errors, [](const auto& e) { return number(e.mean_degrees); });
    j["error_degrees"]["bound"] = or_null(matrices.error_bound_degrees(), number);
    j["error_degrees"]["at"] = or_null(errors, [](const auto& e) { return triple(e.at.xyz); });
    j["probe"] = or_null(frame.probe, probe_json);
    return json_text(j) + "\n";
}

}  // namespace normalscope

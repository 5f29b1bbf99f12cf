#include "core/explain/numbers_json.h"

#include "core/base/json_text.h"
#include "core/explain/json_values.h"
#include "core/scene/scene_json.h"
#include "core/surface/worst_dots.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

Json probe_json(const ProbeInWorld& p, const ImplicitSurface* implicit) {
    const auto vector = [](const auto& v) { return json_vector(v.xyz); };
    const auto pair = [&](const auto& tangents) { return Json::array({vector(tangents[0]), vector(tangents[1])}); };
    Json j;
    j["point_object"] = vector(p.object.point);
    j["point_world"] = vector(p.point);
    const bool any = p.object.has_normal();
    j["n_object"] = any ? vector(p.object.normal) : Json(nullptr);
    j["n_world"] = json_by_rule(p.normals, [&](const auto& n) { return json_or_null(n, vector); });
    if (!p.affine) j["true_normal"] = json_or_null(p.truth, vector);  // otherwise a rule's, above
    j["tangents_object"] = any ? pair(p.object.tangents) : Json(nullptr);
    j["tangents_world"] = any ? pair(p.tangents) : Json(nullptr);
    const auto corners = [&](const auto& polygon) {
        Json list = Json::array();
        for (const auto& corner : polygon) list.push_back(vector(corner));
        return list.empty() ? Json(nullptr) : list;
    };
    j["polygon_object"] = corners(p.object.polygon);
    j["polygon_world"] = corners(p.polygon);
    j["dots"] = json_by_rule(p.dots, [](const auto& d) {
        return json_or_null(d, [](const auto& v) { return Json::array({json_number(v[0]), json_number(v[1])}); });
    });
    j["f"] = nullptr;  // formulas only
    j["gradient"] = nullptr;
    if (implicit) {
        const formulas::Sample s = implicit->written_at(p.object.point);
        j["f"] = json_number(s.value);
        if (std::isfinite(s.gradient.x) && std::isfinite(s.gradient.y) && std::isfinite(s.gradient.z))
            j["gradient"] = json_vector(s.gradient);
    }
    // Where the gradient is zero there is no normal: the one above is that of this neighbour.
    if (p.object.borrowed_from) j["borrowed_from"] = vector(*p.object.borrowed_from);
    return j;
}

Json flat_json(const FlatView& view) {
    const auto pair = [](const auto& v) { return json_or_null(v, [](const glm::dvec2& p) { return json_vector(p); }); };
    Json j;
    j["curves"] = view.cut->curves.size();
    j["length"] = json_number(view.cut->length);
    j["plane_normal"] = json_vector(view.plane.normal);
    j["n_object"] = pair(view.n_object);
    j["n_world"] = json_by_rule(view.normals, pair);
    j["tangent"] = pair(view.tangent);
    j["error_degrees"] = json_or_null(view.error_degrees, json_number);
    j["factors"] = json_by_rule(view.factors, pair);
    j["note"] = view.note.empty() ? Json(nullptr) : Json(view.note);
    return j;
}

}  // namespace

Json numbers_json(const Scene& scene, const Frame& frame, const std::optional<Drawn>& drawn) {
    const Transform<World, Object> m = world_from_object(scene);
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const auto mistaken = normal_map(scene, m, Rule::Naive);
    const auto errors = mistaken ? error_statistics(frame.surface->mesh, *mistaken, m) : std::nullopt;

    Json j;
    const auto of_drawing = [&](std::string Drawn::* what) { return drawn ? Json((*drawn).*what) : Json(nullptr); };
    j["program"] = of_drawing(&Drawn::program);
    j["renderer"] = of_drawing(&Drawn::renderer);
    j["gl_version"] = of_drawing(&Drawn::gl_version);
    j["context"] = of_drawing(&Drawn::context);
    j["mistake"] = std::string(name(scene.mistake));  // what stands in the naive rule's place below
    j["power"] = json_number(shown_power(scene));     // and to which it is bent
    j["M"] = json_rows(m.matrix());
    j["affine"] = m.affine();
    j["determinant"] = json_number(matrices.determinant);
    j["rank"] = matrices.rank;
    j["condition"] = json_or_null(matrices.condition(), json_number);
    for (const Rule rule : kRules)
        j["normal_matrix"][std::string(name(rule))] =
            json_or_null(rule == Rule::Naive ? between_the_rules(matrices, shown_power(scene)) : matrices.by(rule),
                         [](const auto& n) { return json_rows(n); });
    j["error_degrees"]["worst"] = json_or_null(errors, [](const auto& e) { return json_number(e.worst_degrees); });
    j["error_degrees"]["mean"] = json_or_null(errors, [](const auto& e) { return json_number(e.mean_degrees); });
    j["error_degrees"]["bound"] =
        json_or_null(m.affine() ? matrices.error_bound_degrees(shown_power(scene)) : std::nullopt, json_number);
    j["error_degrees"]["at"] = json_or_null(errors, [](const auto& e) { return json_vector(e.at.xyz); });
    const ByRule<std::optional<NormalMap>> maps{mistaken, normal_map(scene, m, Rule::InverseTranspose),
                                                normal_map(scene, m, Rule::Cofactor)};
    const auto tangents = mistaken_tangents(scene, m);
    const auto dots =
        tangents ? worst_dots(frame.surface->mesh.normals, maps, *tangents) : worst_dots(frame.surface->mesh, maps, m);
    for (const Rule rule : kRules) j["worst_dot"][std::string(name(rule))] = json_or_null(dots[rule], json_number);
    const Mesh& mesh = frame.surface->mesh;  // as it is drawn
    j["surface"] = {{"triangles", mesh.triangles.size()}, {"vertices", mesh.positions.size()}, {"notes", frame.notes}};
    j["probe"] =
        json_or_null(frame.probe, [&](const ProbeInWorld& p) { return probe_json(p, frame.surface->implicit.get()); });
    j["pinned"] = Json::array();
    for (const auto& pinned : frame.pinned)
        j["pinned"].push_back(json_or_null(pinned, [&](const ProbeInWorld& p) {
            Json row = probe_json(p, frame.surface->implicit.get());
            row["error_degrees"] = json_or_null(p.error_degrees, json_number);
            return row;
        }));
    j["flat"] = json_or_null(frame.flat, flat_json);
    return j;
}

std::string numbers_text(const Scene& scene, const Frame& frame, const Drawn& drawn) {
    return json_text(numbers_json(scene, frame, drawn)) + "\n";
}

}  // namespace normalscope

// The explanation for programs.

#include "core/base/json_text.h"
#include "core/explain/explanation.h"
#include "core/explain/json_values.h"
#include "core/explain/numbers_json.h"
#include "core/formula/print.h"

#include <glm/geometric.hpp>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

// A number, an array, or an array of rows, as computed.
Json json_of(const Value& v) {
    if (v.is_number()) return json_number(v.entries[0]);
    Json result = Json::array();
    for (int r = 0; r < v.rows; ++r) {
        Json row = Json::array();
        for (int c = 0; c < v.columns; ++c) row.push_back(json_number(v(r, c)));
        result.push_back(v.columns == 1 ? row[0] : row);
    }
    return v.rows == 1 ? result[0] : result;
}
Json json_of(const std::optional<Value>& v) { return v ? json_of(*v) : Json(nullptr); }
Json json_of(const std::optional<double>& v) { return json_or_null(v, json_number); }
Json json_of(const std::optional<bool>& v) { return v ? Json(*v) : Json(nullptr); }

Json json_of(const std::optional<Difference>& d) {
    return json_or_null(d, [](const Difference& v) {
        return Json{{"largest", json_number(v.largest)},
                    {"rounding", json_number(v.rounding)},
                    {"relative", json_number(v.relative)}};
    });
}

Json json_of(const Expression& e) {
    Json j;
    j["kind"] = name(e.kind);
    if (e.kind == Expression::Kind::Symbol) j["symbol"] = name(e.symbol);
    if (e.kind != Expression::Kind::Equals) j["value"] = json_of(e.value);
    for (const Expression& operand : e.operands) j["operands"].push_back(json_of(operand));
    return j;
}

Json json_of(const Step& s) {
    Json j;
    j["id"] = s.id;
    j["line"] = expression_text(s.line);
    j["reason"] = s.reason;
    j["remark"] = s.remark.empty() ? Json(nullptr) : Json(s.remark);
    j["state"] = name(s.state);
    j["left"] = json_of(s.left().value);
    j["right"] = json_of(s.right().value);
    j["residual"] = json_of(s.residual);
    j["expression"] = json_of(s.line);
    return j;
}

Json json_of(const RuleCheck& c) {
    Json j;
    j["n_world"] = json_of(c.normal);
    j["dots"] = Json::array({json_of(c.dots[0]), json_of(c.dots[1])});
    j["degrees_between"] = Json::array({json_of(c.degrees_between[0]), json_of(c.degrees_between[1])});
    j["degrees_off"] = json_of(c.degrees_off);
    return j;
}

Json json_of(const HomogeneousDemo& d) {
    return {{"point_before", json_of(d.before[0])},          {"point_after", json_of(d.after[0])},
            {"vector_before", json_of(d.before[1])},         {"vector_after", json_of(d.after[1])},
            {"normal_as_point", json_of(d.normal_as_point)}, {"reason", d.reason}};
}

Json json_of(const EntryAlgebra& e) {
    return {{"kind", e.kind},
            {"A", json_of(e.a)},
            {"inverse", json_of(e.inverse)},
            {"inverse_transpose", json_of(e.inverse_transpose)},
            {"observations", e.observations},
            {"product", json_of(e.product)},
            {"composite_of_inverses", json_of(e.composite)},
            {"inverse_of_composite", json_of(e.inverted_product)},
            {"difference", json_of(e.apart)}};
}

Json json_of(const OrderOfInverses& o) {
    return {{"id", o.id},
            {"formula", o.formula},
            {"reason", o.reason},
            {"matrix", json_of(o.matrix)},
            {"degrees_off", json_of(o.degrees_off)},
            {"right", o.is_right}};
}

Json json_of(const Decomposition& d) {
    Json j{{"rotation", json_rows(d.rotation)},
           {"stretch", json_rows(d.stretch)},
           {"reflects", d.reflects},
           {"axis", json_vector(d.axis)},
           {"degrees", json_number(d.degrees)},
           {"unique", d.unique},
           {"axes", Json::array()}};
    for (const StretchAxis& a : d.axes)
        j["axes"].push_back({{"from", json_vector(a.from.xyz)},
                             {"to", json_vector(a.to.xyz)},
                             {"factor", json_number(a.factor)},
                             {"unique", a.unique}});
    j["worst"] = json_or_null(d.worst, [](const WorstNormal& w) {
        Json normals = Json::array();
        for (std::size_t i = 0; i < 2; ++i)
            normals.push_back({{"n_object", json_vector(w.object[i].xyz)},
                               {"naive", json_vector(w.naive[i].xyz)},
                               {"right", json_vector(w.right[i].xyz)}});
        return Json{{"degrees", json_number(w.degrees)}, {"normals", normals}};
    });
    return j;
}

Json json_of(const MapClaims& c) {
    return {{"naive_direction_right", json_of(c.naive_direction_right)},
            {"worst_degrees", json_of(c.worst_degrees)},
            {"naive_length_right", json_of(c.naive_length_right)},
            {"inverse_transpose_exists", c.inverse_transpose_exists},
            {"cofactor", name(c.cofactor)},
            {"rank", c.rank},
            {"condition", json_of(c.condition)},
            {"digits_lost", json_of(c.digits_lost)}};
}

Json json_of(const GradientReport& g) {
    Json j{{"f", json_number(g.f)},
           {"gradient", json_or_null(g.gradient, [](const auto& v) { return json_vector(v); })},
           {"length", json_or_null(g.gradient, [&](const auto&) { return json_number(g.length); })},
           {"normal", json_or_null(g.normal, [](const auto& n) { return json_vector(n.xyz); })}};
    j["differences"] = {{"step", json_number(g.step)},
                        {"gradient", json_vector(g.differences.vector)},
                        {"degrees_off", json_of(g.differences.degrees_off)}};
    j["polygon"] = json_or_null(g.polygon, [](const GradientReport::Other& p) {
        return Json{{"normal", json_vector(p.vector)}, {"degrees_off", json_of(p.degrees_off)}};
    });
    return j;
}

// As parse() reads them: null for what is too long for anybody.
Json formula_json(const ImplicitSurface& surface) {
    constexpr std::array<const char*, 4> kKeys{"f", "df/dx", "df/dy", "df/dz"};
    const formulas::Formula& formula = surface.formula();
    Json j;
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        const std::vector<formulas::Piece> pieces = formulas::pieces(formula.graph, formula.expressions()[i]);
        const bool whole = pieces.back().kind != formulas::Piece::Kind::Truncated;
        j[kKeys[i]] = whole ? Json(formulas::to_text(pieces)) : Json(nullptr);
    }
    j["parameters"] = Json::object();
    for (const char letter : formula.parameters)
        j["parameters"][std::string(1, letter)] =
            json_number(surface.source().parameters[formulas::kParameterNames.find(letter)]);
    return j;
}

}  // namespace

std::string explanation_json(const Scene& scene, const Frame& frame, const Explanation& e) {
    Json j = numbers_json(scene, frame, std::nullopt);
    j["about"] = e.about;
    j["notes"] = e.notes;
    j["n_world_by"] = e.derivation.n_world_by ? Json(name(*e.derivation.n_world_by)) : Json(nullptr);
    j["formula"] = e.implicit ? formula_json(*e.implicit) : Json(nullptr);
    j["gradient"] = json_or_null(e.gradient, [](const GradientReport& g) { return json_of(g); });
    j["derivation"] = Json::array();
    for (const Step& step : e.derivation.steps) j["derivation"].push_back(json_of(step));
    j["check"] = json_by_rule(e.derivation.checks, [](const RuleCheck& c) { return json_of(c); });
    j["homogeneous"] = json_of(e.derivation.homogeneous);
    j["stack"] = Json::array();
    for (const EntryAlgebra& entry : e.stack) j["stack"].push_back(json_of(entry));
    j["orders"] = Json::array();
    for (const OrderOfInverses& order : e.orders) j["orders"].push_back(json_of(order));
    j["decomposition"] = json_of(e.decomposition);
    j["claims"] = json_of(e.claims);
    j["classes"] = Json::array();
    for (const MapClassRow& row : e.classes) {
        Json of_class{{"class", name(row.map_class)},
                      {"that_is", meaning(row.map_class)},
                      {"contains_M", row.contains_m},
                      {"of", json_rows(row.of)}};
        of_class["claims"] = json_of(row.claims);
        j["classes"].push_back(of_class);
    }
    return json_text(j) + "\n";
}

}  // namespace normalscope

#include "core/scene/scene_json.h"

#include "core/base/json_object.h"
#include "core/base/json_reading.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/formula/formula.h"
#include "core/scene/scene_fields.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

template <class E>
std::string_view enum_name(E value) {
    for (const auto& [e, n] : names_of(value))
        if (e == value) return n;
    return "";
}

// ---- writing -------------------------------------------------------------------------------------------------

Json json_of(bool v) { return v; }
Json json_of(int v) { return v; }
Json json_of(double v) { return v; }
Json json_of(const std::string& v) { return v; }
Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }
template <class Space>
Json json_of(const Point<Space>& p) {
    return json_of(p.xyz);
}
Json json_of(const glm::dmat4& m) {
    Json rows = Json::array();
    for (int r = 0; r < 4; ++r) rows.push_back(Json::array({m[0][r], m[1][r], m[2][r], m[3][r]}));
    return rows;
}
template <class E>
    requires std::is_enum_v<E>
Json json_of(E v) {
    return std::string(enum_name(v));
}
template <class V>
Json json_of(const ParametersOf<V>& p);
template <class T>
Json json_of(const std::optional<T>& v);
template <class T>
Json json_of(const std::vector<T>& v);
Json json_of(const SurfaceSource& s);
Json json_of(const StackEntry& e);
template <class T>
    requires std::is_class_v<T>
Json json_of(const T& v);

struct Writer {
    Json& object;
    template <class T, class... R>
    void operator()(const char* key, const T& value, R...) {
        object[key] = json_of(value);
    }
};

template <class T>
Json json_of(const std::optional<T>& v) {
    return v ? json_of(*v) : Json(nullptr);
}
template <class T>
Json json_of(const std::vector<T>& v) {
    Json array = Json::array();
    for (const T& e : v) array.push_back(json_of(e));
    return array;
}
template <class T>
    requires std::is_class_v<T>
Json json_of(const T& v) {
    Json object = Json::object();
    Writer writer{object};
    fields(writer, v);
    return object;
}
template <class V>
Json json_of(const ParametersOf<V>& p) {
    Json object = Json::object();
    for (const char letter : formulas::parameters_in(p.formula))
        object[std::string(1, letter)] = p.values[formulas::kParameterNames.find(letter)];
    return object;
}
Json json_of(const SurfaceSource& s) {
    return std::visit([](const auto& source) { return json_of(source); }, s);
}
Json json_of(const Scale& s) { return json_of(s.factors); }
Json json_of(const Translate& t) { return json_of(t.offset); }
Json json_of(const Matrix& m) { return json_of(m.matrix); }
Json json_of(const StackEntry& e) {
    Json object = Json::object();
    object[std::string(name(e))] = std::visit([](const auto& entry) { return json_of(entry); }, e);
    return object;
}

// ---- reading -------------------------------------------------------------------------------------------------

using normalscope::read_value;  // of what has no parts

void read_array(const Json& j, const JsonPath& path, std::size_t size, const std::string& of) {
    if (!j.is_array() || j.size() != size) fail_kind(path, "an array of " + std::to_string(size) + " " + of, j);
}
void read_value(const Json& j, const JsonPath& path, glm::dvec3& v, Range range) {
    read_array(j, path, 3, "numbers");
    for (std::size_t i = 0; i < 3; ++i) read_value(j[i], below(path, i), v[static_cast<int>(i)], range);
}
template <class Space>
void read_value(const Json& j, const JsonPath& path, Point<Space>& p) {
    read_value(j, path, p.xyz, kCoordinate);
}
void read_value(const Json& j, const JsonPath& path, glm::dmat4& m) {
    read_array(j, path, 4, "rows");
    for (std::size_t r = 0; r < 4; ++r) {
        const JsonPath row = below(path, r);
        read_array(j[r], row, 4, "numbers");
        for (std::size_t c = 0; c < 4; ++c)
            read_value(j[r][c], below(row, c), m[static_cast<int>(c)][static_cast<int>(r)], kCoordinate);
    }
}
template <class E>
    requires std::is_enum_v<E>
void read_value(const Json& j, const JsonPath& path, E& v) {
    if (j.is_string())
        for (const auto& [e, n] : names_of(v))
            if (j.get_ref<const std::string&>() == n) {
                v = e;
                return;
            }
    std::vector<std::string> valid;
    for (const auto& [e, n] : names_of(v)) valid.emplace_back(n);
    fail_kind(path, "one of " + joined(valid), j);
}
template <class T, class... R>
void read_value(const Json& j, const JsonPath& path, std::optional<T>& v, R... range);
template <class T>
void read_value(const Json& j, const JsonPath& path, std::vector<T>& v, AtMost most = {});
void read_value(const Json& j, const JsonPath& path, SurfaceSource& v);
void read_value(const Json& j, const JsonPath& path, ParametersOf<formulas::Parameters>& p);
void read_value(const Json& j, const JsonPath& path, StackEntry& v);
template <class T>
    requires std::is_class_v<T>
void read_value(const Json& j, const JsonPath& path, T& v);

struct Reader {
    JsonObject& object;
    template <class T, class... R>
    void operator()(const char* key, T&& value, R... range) {
        if (const Json* j = object.find(key)) read_value(*j, object.at(key), value, range...);
    }
};

void read_value(const Json& j, const JsonPath& path, ParametersOf<formulas::Parameters>& p) {
    if (!j.is_object()) fail_kind(path, "an object", j);
    std::vector<std::string> known;
    for (const char letter : formulas::parameters_in(p.formula)) known.emplace_back(1, letter);
    for (const auto& [key, value] : j.items()) {
        if (std::ranges::count(known, key) == 0)
            throw JsonError(below(path, key), known.empty()
                                                  ? "the formula has no parameters"
                                                  : "the formula has no such parameter; it has " + joined(known));
        read_value(value, below(path, key), p.values[formulas::kParameterNames.find(key)], kCoordinate);
    }
}

template <class T, class... R>
void read_value(const Json& j, const JsonPath& path, std::optional<T>& v, R... range) {
    if (j.is_null())
        v.reset();
    else
        read_value(j, path, v.emplace(), range...);
}
template <class T>
void read_value(const Json& j, const JsonPath& path, std::vector<T>& v, AtMost most) {
    if (!j.is_array()) fail_kind(path, "an array", j);
    if (j.size() > most.count)
        throw JsonError(path, "has " + std::to_string(j.size()) + " " + std::string(most.of) + "; at most " +
                                  std::to_string(most.count) + " are allowed" + std::string(most.remedy));
    v.assign(j.size(), T{});
    for (std::size_t i = 0; i < j.size(); ++i) read_value(j[i], below(path, i), v[i]);
}
template <class T>
    requires std::is_class_v<T>
void read_value(const Json& j, const JsonPath& path, T& v) {
    JsonObject object(j, path);
    Reader reader{object};
    fields(reader, v);
    object.no_other_keys();
}

// The one of `kinds` that the object has for a key.
std::string kind_of(const Json& j, const JsonPath& path, std::span<const std::string> kinds) {
    std::string found;
    if (j.is_object())
        for (const std::string& kind : kinds) {
            if (!j.contains(kind)) continue;
            if (!found.empty()) throw JsonError(path, "has both " + found + " and " + kind + "; keep one");
            found = kind;
        }
    if (found.empty()) fail_kind(path, "an object with one of " + joined(kinds), j);
    return found;
}

void read_value(const Json& j, const JsonPath& path, SurfaceSource& v) {
    const std::string kind = kind_of(j, path, surface_kinds());
    if (kind == "shape")
        read_value(j, path, v.emplace<ShapeSurface>());
    else if (kind == "mesh")
        read_value(j, path, v.emplace<MeshSurface>());
    else
        read_value(j, path, v.emplace<FormulaSurface>());
    if (const FormulaSurface* f = std::get_if<FormulaSurface>(&v)) {
        try {
            (void)formulas::read(f->formula);
        } catch (const InputError& e) {
            throw JsonError(below(path, "formula"), e.what());
        }
    }
    if (const MeshSurface* m = std::get_if<MeshSurface>(&v); m && m->mesh.empty())
        throw JsonError(below(path, "mesh"), "is empty; it is a file's name, ending in .obj, .ply or .stl");
}

void read_value(const Json& j, const JsonPath& path, StackEntry& v) {
    const std::string kind = kind_of(j, path, stack_kinds());
    if (j.size() != 1) throw JsonError(path, "has other keys beside " + kind + "; each entry is one transform");
    const JsonPath at = below(path, kind);
    const Json& body = j[kind];
    if (kind == "scale")
        read_value(body, at, v.emplace<Scale>().factors, kCoordinate);
    else if (kind == "rotate")
        read_value(body, at, v.emplace<Rotate>());
    else if (kind == "translate")
        read_value(body, at, v.emplace<Translate>().offset, kCoordinate);
    else if (kind == "shear")
        read_value(body, at, v.emplace<Shear>());
    else
        read_value(body, at, v.emplace<Matrix>().matrix);
    if (const Rotate* r = std::get_if<Rotate>(&v); r && glm::length(r->axis) == 0.0)
        throw JsonError(below(at, "axis"), "is zero, so it has no direction; try [0, 0, 1]");
}

}  // namespace

std::span<const std::string> surface_kinds() {
    static const std::array<std::string, 3> kinds{"shape", "mesh", "formula"};
    return kinds;
}
std::span<const std::string> stack_kinds() {
    static const std::array<std::string, 5> kinds{"scale", "rotate", "translate", "shear", "matrix"};
    return kinds;
}

Json scene_json(const Scene& scene) {
    Json root = Json::object();
    root["normalscope"] = 1;
    root.update(json_of(scene));
    return root;
}

Json json_when_on(std::string_view key) {
    if (key == "slice") return json_of(Slice{});
    if (key == "borrow") return json_of(Direction<Object>{});
    if (key == "ray") return json_of(AimedRay{});
    return nullptr;
}

Scene scene_of_json(const Json& json, const JsonPath& path) {
    Scene scene;
    JsonObject object(json, path, "a scene, which is an object");
    Reader reader{object};
    fields(reader, scene);
    object.read_format("normalscope");
    object.no_other_keys();
    try {
        (void)world_from_object(scene);  // overflow is an error of the scene, found before anything is drawn
    } catch (const InputError& e) {
        throw JsonError(below(path, "stack"), e.reason);
    }
    return scene;
}

std::string scene_text(const Scene& scene) { return json_text(scene_json(scene)); }

Scene parse_scene(std::string_view text, const std::string& source) {
    try {
        return scene_of_json(read_json(text));
    } catch (const JsonError& e) {
        throw InputError(source, e.what());
    }
}

bool same_subject(const Scene& a, const Scene& b) {
    const auto subject = [](const Scene& s) {
        return std::tie(s.surface, s.stack, s.stack_position, s.mistake, s.power);
    };
    return subject(a) == subject(b);
}

std::string_view name(Shape v) { return enum_name(v); }
std::string_view name(ViewMode v) { return enum_name(v); }
std::string_view name(ArrowPlacement v) { return enum_name(v); }
std::string_view name(ArrowKind v) { return enum_name(v); }
std::string_view name(Mistake v) { return enum_name(v); }
std::string_view name(SurfaceColor v) { return enum_name(v); }
std::string_view name(Theme v) { return enum_name(v); }

}  // namespace normalscope

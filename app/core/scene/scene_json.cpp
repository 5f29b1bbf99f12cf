#include "core/scene/scene_json.h"

#include "core/base/error.h"
#include "core/base/json_reading.h"
#include "core/base/json_text.h"
#include "core/formula/formula.h"
#include "core/formula/parse.h"
#include "core/scene/scene_fields.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

// Keys that say which alternative an object is; setting one replaces the others.
const std::vector<std::vector<std::string>> kAlternatives{{"shape", "mesh", "formula"},
                                                          {"scale", "rotate", "translate", "shear", "matrix"}};

// Of the parameters in a formula; none where it cannot be read.
std::string letters(const std::string& formula) {
    try {
        formulas::Graph graph;
        return formulas::parameters_of(graph, formulas::parse(graph, formula));
    } catch (const InputError&) {
        return {};
    }
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

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
    template <class T>
    void operator()(const char* key, const T& value, Range = kCoordinate) {
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
    for (const char letter : letters(p.formula))
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

Json json_of_scene(const Scene& scene) {
    Json root = Json::object();
    root["normalscope"] = 1;
    const Json keys = json_of(scene);
    root.update(keys);
    return root;
}

// ---- reading -------------------------------------------------------------------------------------------------

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    std::string line = path + ": " + what;
    // A key may hold anything, such as a line break.
    std::ranges::replace_if(line, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
    throw InputError(line);
}

std::string shown(const Json& j) {
    std::string text = j.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}
[[noreturn]] void fail_type(const std::string& path, const std::string& expected, const Json& found) {
    fail(path, "expected " + expected + ", found " + shown(found));
}

std::string child(const std::string& path, const std::string& key) {
    return path.empty() || path.ends_with(' ') ? path + key : path + "." + key;
}

void read(const Json& j, const std::string& path, bool& v) {
    if (!j.is_boolean()) fail_type(path, "true or false", j);
    v = j.get<bool>();
}
void read(const Json& j, const std::string& path, std::string& v) {
    if (!j.is_string()) fail_type(path, "a string", j);
    v = j.get<std::string>();
}
void read(const Json& j, const std::string& path, double& v, Range range) {
    if (!j.is_number()) fail_type(path, "a number", j);
    const double number = j.get<double>();
    if (!(number >= range.low && number <= range.high))
        fail(path, shown(j) + " is out of range; it goes from " + shown(range.low) + " to " + shown(range.high));
    v = number;
}
void read(const Json& j, const std::string& path, int& v, Range range) {
    double number = 0.0;
    read(j, path, number, range);
    if (number != std::floor(number)) fail_type(path, "a whole number", j);
    v = static_cast<int>(number);
}
void read_array(const Json& j, const std::string& path, std::size_t size, const std::string& of) {
    if (!j.is_array() || j.size() != size) fail_type(path, "an array of " + std::to_string(size) + " " + of, j);
}
void read(const Json& j, const std::string& path, glm::dvec3& v, Range range) {
    read_array(j, path, 3, "numbers");
    for (int i = 0; i < 3; ++i) read(j[static_cast<std::size_t>(i)], child(path, std::to_string(i)), v[i], range);
}
template <class Space>
void read(const Json& j, const std::string& path, Point<Space>& p) {
    read(j, path, p.xyz, kCoordinate);
}
void read(const Json& j, const std::string& path, glm::dmat4& m) {
    read_array(j, path, 4, "rows");
    for (int r = 0; r < 4; ++r) {
        const Json& row = j[static_cast<std::size_t>(r)];
        const std::string row_path = child(path, std::to_string(r));
        read_array(row, row_path, 4, "numbers");
        for (int c = 0; c < 4; ++c)
            read(row[static_cast<std::size_t>(c)], child(row_path, std::to_string(c)), m[c][r], kCoordinate);
    }
}
template <class E>
    requires std::is_enum_v<E>
void read(const Json& j, const std::string& path, E& v) {
    if (j.is_string())
        for (const auto& [e, n] : names_of(v))
            if (j.get<std::string>() == n) {
                v = e;
                return;
            }
    std::vector<std::string> valid;
    for (const auto& [e, n] : names_of(v)) valid.emplace_back(n);
    fail_type(path, "one of " + joined(valid), j);
}
template <class T, class... R>
void read(const Json& j, const std::string& path, std::optional<T>& v, R... range);
template <class T>
void read(const Json& j, const std::string& path, std::vector<T>& v);
void read(const Json& j, const std::string& path, SurfaceSource& v);
void read(const Json& j, const std::string& path, ParametersOf<formulas::Parameters>& p);
void read(const Json& j, const std::string& path, StackEntry& v);
template <class T>
    requires std::is_class_v<T>
void read(const Json& j, const std::string& path, T& v);

struct Reader {
    const Json& object;
    const std::string& path;
    std::vector<std::string> known;

    template <class T, class... R>
    void operator()(const char* key, T&& value, R... range) {
        known.emplace_back(key);
        if (const auto it = object.find(key); it != object.end()) read(*it, child(path, key), value, range...);
    }
    void no_other_keys() const {
        for (const auto& [key, value] : object.items())
            if (std::ranges::count(known, key) == 0)
                fail(child(path, key), "unknown key; known here: " + joined(known));
    }
};

void read(const Json& j, const std::string& path, ParametersOf<formulas::Parameters>& p) {
    if (!j.is_object()) fail_type(path, "an object", j);
    const std::string known = letters(p.formula);
    for (const auto& [key, value] : j.items()) {
        if (key.size() != 1 || known.find(key) == std::string::npos) {
            std::string text = "the formula has no such parameter; ";
            for (const char c : known) text += (c == known.front() ? "it has " : ", ") + std::string(1, c);
            fail(child(path, key), known.empty() ? "the formula has no parameters" : text);
        }
        read(value, child(path, key), p.values[formulas::kParameterNames.find(key)], kCoordinate);
    }
}

template <class T, class... R>
void read(const Json& j, const std::string& path, std::optional<T>& v, R... range) {
    if (j.is_null())
        v.reset();
    else
        read(j, path, v.emplace(), range...);
}
template <class T>
void read(const Json& j, const std::string& path, std::vector<T>& v) {
    if (!j.is_array()) fail_type(path, "an array", j);
    if (j.size() > kMostStackEntries)
        fail(path, "has " + std::to_string(j.size()) + " entries; at most " + std::to_string(kMostStackEntries) +
                       " are allowed, so multiply some into one matrix");
    v.assign(j.size(), T{});
    for (std::size_t i = 0; i < j.size(); ++i) read(j[i], child(path, std::to_string(i)), v[i]);
}
template <class T>
    requires std::is_class_v<T>
void read(const Json& j, const std::string& path, T& v) {
    if (!j.is_object()) fail_type(path, "an object", j);
    Reader reader{j, path, {}};
    fields(reader, v);
    reader.no_other_keys();
}

// The one of `keys` that the object has.
std::string alternative(const Json& j, const std::string& path, const std::vector<std::string>& keys) {
    if (!j.is_object()) fail_type(path, "an object with one of " + joined(keys), j);
    std::string found;
    for (const std::string& key : keys) {
        if (!j.contains(key)) continue;
        if (!found.empty()) fail(path, "has both " + found + " and " + key + "; keep one");
        found = key;
    }
    if (found.empty()) fail_type(path, "an object with one of " + joined(keys), j);
    return found;
}

void read(const Json& j, const std::string& path, SurfaceSource& v) {
    const std::string kind = alternative(j, path, kAlternatives[0]);
    if (kind == "shape")
        read(j, path, v.emplace<ShapeSurface>());
    else if (kind == "mesh")
        read(j, path, v.emplace<MeshSurface>());
    else
        read(j, path, v.emplace<FormulaSurface>());
    if (const FormulaSurface* f = std::get_if<FormulaSurface>(&v)) {
        try {
            (void)formulas::read(f->formula);
        } catch (const InputError& e) {
            fail(child(path, "formula"), e.what());
        }
    }
}

void read(const Json& j, const std::string& path, StackEntry& v) {
    const std::string kind = alternative(j, path, kAlternatives[1]);
    if (j.size() != 1) fail(path, "has other keys beside " + kind + "; each entry is one transform");
    const std::string at = child(path, kind);
    const Json& body = j[kind];
    if (kind == "scale")
        read(body, at, v.emplace<Scale>().factors, kCoordinate);
    else if (kind == "rotate")
        read(body, at, v.emplace<Rotate>());
    else if (kind == "translate")
        read(body, at, v.emplace<Translate>().offset, kCoordinate);
    else if (kind == "shear")
        read(body, at, v.emplace<Shear>());
    else
        read(body, at, v.emplace<Matrix>().matrix);
    if (const Rotate* r = std::get_if<Rotate>(&v); r && glm::length(r->axis) == 0.0)
        fail(child(at, "axis"), "is zero, so it has no direction; try [0, 0, 1]");
}

Scene scene_of(Json root, const std::string& prefix) {
    if (!root.is_object()) fail(prefix + "scene", "expected an object, found " + shown(root));
    if (const auto it = root.find("normalscope"); it != root.end()) {
        if (!it->is_number_integer()) fail_type(prefix + "normalscope", "the format's number, 1", *it);
        if (*it != 1)
            fail(prefix + "normalscope", "format " + shown(*it) + " is not known; this program reads format 1");
        root.erase(it);
    }
    Scene scene;
    Reader reader{root, prefix, {}};
    fields(reader, scene);
    reader.known.emplace_back("normalscope");
    reader.no_other_keys();
    try {
        (void)world_from_object(scene);  // overflow is an error of the scene, found before anything is drawn
    } catch (const InputError& e) {
        throw InputError(prefix + e.what());
    }
    return scene;
}

constexpr int kDeepest = 32;  // a scene is at most seven levels deep

// ---- --set ---------------------------------------------------------------------------------------------------

// What is no JSON is a bare word, and so a string.
Json setting_value(const std::string& text, const std::string& path) {
    try {
        if (std::optional<Json> value = read_json_or_nothing(text, kDeepest)) return *std::move(value);
        if (text.starts_with('[') || text.starts_with('{') || text.starts_with('"'))
            throw InputError(json_depth(text) > kDeepest
                                 ? "nested too deep for a scene"
                                 : text.substr(0, 60) + " is not valid JSON; a bracket or a quote is missing");
        return text;  // a bare word
    } catch (const InputError& e) {
        throw InputError("--set " + path + ": " + e.what());
    }
}

Json& element(Json& array, const std::string& path, const std::string& key) {
    const bool digits =
        !key.empty() && key.size() < 7 && std::ranges::all_of(key, [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t index = digits ? static_cast<std::size_t>(std::stoul(key)) : array.size() + 1;
    // One past the end of the stack appends an entry.
    if (index == array.size() && path == "stack") array.push_back(Json::object());
    if (index >= array.size())
        fail("--set " + child(path, key),
             "no such entry; there are " + std::to_string(array.size()) + ", counted from 0");
    return array[index];
}

Json& member(Json& object, const std::string& path, const std::string& key) {
    // What is off is switched on by setting a part of it.
    if (object.is_null() && path == "slice") object = json_of(Slice{});
    if (object.is_null() && path == "borrow") object = json_of(Borrow{});
    if (object.is_null() && path == "ray") object = json_of(AimedRay{});
    if (!object.is_object()) fail("--set " + child(path, key), "there is nothing below " + shown(object));
    // Another kind of surface or of entry replaces the one that is there.
    const std::vector<std::string>* kinds = path == "surface"            ? &kAlternatives[0]
                                            : path.starts_with("stack.") ? &kAlternatives[1]
                                                                         : nullptr;
    const bool is_kind = kinds && std::ranges::count(*kinds, key) > 0 && std::ranges::count(path, '.') <= 1;
    if (is_kind && !object.contains(key)) object = Json{{key, nullptr}};
    if (!object.contains(key)) {
        std::vector<std::string> known;
        for (const auto& [k, v] : object.items()) known.push_back(k);
        if (known.empty() && kinds) known = *kinds;
        if (known.empty()) fail("--set " + child(path, key), "there is nothing below " + shown(object));
        fail("--set " + child(path, key), "unknown key; known here: " + joined(known));
    }
    return object[key];
}

}  // namespace

std::string scene_text(const Scene& scene) { return json_text(json_of_scene(scene)); }

Scene parse_scene(std::string_view text, std::string_view source) {
    const std::string name(source);
    return scene_of(read_json(text, name, kDeepest), name + ": ");
}

Scene with_setting(const Scene& scene, std::string_view assignment) {
    const std::string whole(assignment);
    const auto equals = assignment.find('=');
    if (equals == std::string_view::npos || equals == 0)
        throw UsageError("--set " + whole + ": expected PATH=VALUE, such as stack.0.scale=[1,2,1] or rule=naive");
    const std::string value_text(assignment.substr(equals + 1));
    Json value = setting_value(value_text, whole.substr(0, equals));

    std::vector<std::string> keys{""};
    for (const char c : assignment.substr(0, equals))
        if (c == '.')
            keys.emplace_back();
        else
            keys.back() += c;

    Json root = json_of_scene(scene);
    Json* node = &root;
    std::string path;  // of `node`
    for (const std::string& key : keys) {
        node = &(node->is_array() ? element(*node, path, key) : member(*node, path, key));
        path = child(path, key);
    }
    *node = std::move(value);
    if (path == "surface.formula") {
        if (!node->is_string()) *node = value_text;  // a formula may look like a number
        // Another formula has other parameters.
        const std::string known = letters(node->get<std::string>());
        const Json before = root["surface"].value("parameters", Json::object());
        Json kept = Json::object();
        for (const auto& [key, number] : before.items())
            if (known.find(key) != std::string::npos) kept[key] = number;
        root["surface"]["parameters"] = kept;
    }
    Scene result = scene_of(std::move(root), "--set ");
    if (!same_subject(result, scene)) result.about.clear();
    return result;
}

bool same_subject(const Scene& a, const Scene& b) {
    const auto subject = [](const Scene& s) { return std::tie(s.surface, s.stack, s.stack_position, s.mistake); };
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

#include "core/base/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

std::string leaf(const Json& j) { return j.dump(-1, ' ', false, Json::error_handler_t::replace); }

// Short enough for one line: no object or array inside, but for an object of one such value, as in a stack's entries.
bool fits_line(const Json& j) {
    if (!j.is_structured()) return true;
    if (j.is_object()) return j.size() == 1 && fits_line(j.front());
    return std::ranges::none_of(j, [](const Json& e) { return e.is_structured(); });
}

void write(const Json& j, int depth, std::string& out) {
    if (!j.is_structured() || j.empty()) {
        out += leaf(j);
        return;
    }
    const bool object = j.is_object(), line = fits_line(j);
    const std::string indent(static_cast<std::size_t>(2 * depth + 2), ' ');
    out += object ? '{' : '[';
    bool first = true;
    for (const auto& [key, value] : j.items()) {
        out += first ? "" : line ? ", " : ",";
        if (!line) out += "\n" + indent;
        if (object) out += Json(key).dump() + ": ";
        write(value, depth + 1, out);
        first = false;
    }
    if (!line) out += "\n" + indent.substr(2);
    out += object ? '}' : ']';
}

}  // namespace

std::string json_text(const Json& json) {
    std::string out;
    write(json, 0, out);
    return out;
}

}  // namespace normalscope

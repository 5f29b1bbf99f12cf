#include "core/base/json_path.h"

#include "core/base/utf8.h"

#include <utility>

namespace normalscope {

namespace {

constexpr std::size_t kLongestKey = 60, kLongestPath = 240;

}  // namespace

JsonPath below(JsonPath path, std::string key) {
    path.push_back(std::move(key));
    return path;
}
JsonPath below(JsonPath path, std::size_t index) { return below(std::move(path), std::to_string(index)); }

std::string dotted(const JsonPath& path) {
    std::string text;
    for (const std::string& key : path) text += (text.empty() ? "" : ".") + shortened(key, kLongestKey);
    return shortened(text, kLongestPath);
}

JsonError::JsonError(JsonPath where, const std::string& reason_alone)
    : InputError(dotted(where), reason_alone), path(std::move(where)) {}

}  // namespace normalscope

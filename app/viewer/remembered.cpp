#include "viewer/remembered.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostLessons = 200;

constexpr std::array<std::pair<const char*, bool Unfolded::*>, 3> kUnfolded{
    {{"rules", &Unfolded::rules}, {"matrix", &Unfolded::matrix}, {"tabs", &Unfolded::tabs}}};

double factor(const Json& json, const char* key) {
    const auto it = json.find(key);
    return it != json.end() && it->is_number() ? std::clamp(it->get<double>(), 0.6, 3.0) : 1.0;
}

std::map<std::string, std::size_t> steps(const Json& json) {
    std::map<std::string, std::size_t> result;
    const auto it = json.find("lessons");
    if (it == json.end() || !it->is_object()) return result;
    for (const auto& [lesson, step] : it->items())
        if (step.is_number_unsigned() && result.size() < kMostLessons) result[lesson] = step.get<std::size_t>();
    return result;
}

}  // namespace

std::string remembered_text(const Remembered& remembered) {
    Json json;
    json["interface_scale"] = remembered.scale.interface;
    json["presenter_scale"] = remembered.scale.presenter;
    if (!remembered.motion) json["motion"] = false;
    for (const auto& [name, part] : kUnfolded)
        if (remembered.unfolded.*part) json["unfolded"].push_back(name);
    for (const auto& [lesson, step] : remembered.lessons) json["lessons"][lesson] = step;
    if (!remembered.recent_files.empty()) json["recent_files"] = remembered.recent_files;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Remembered remembered_of(std::string_view text) {
    Remembered remembered;
    const Json json = Json::parse(text, nullptr, false);
    remembered.first = !json.is_object();
    if (remembered.first) return remembered;
    if (const auto parts = json.find("unfolded"); parts != json.end() && parts->is_array())
        for (const auto& [name, part] : kUnfolded) remembered.unfolded.*part = std::ranges::count(*parts, name) > 0;
    remembered.scale.interface = factor(json, "interface_scale");
    remembered.scale.presenter = factor(json, "presenter_scale");
    remembered.lessons = steps(json);
    if (const auto files = json.find("recent_files"); files != json.end() && files->is_array())
        for (const Json& file : *files)
            if (file.is_string()) remembered.recent_files.push_back(file.get<std::string>());
    if (const auto motion = json.find("motion"); motion != json.end() && motion->is_boolean())
        remembered.motion = motion->get<bool>();
    return remembered;
}

}  // namespace normalscope

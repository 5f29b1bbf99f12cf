#include "commands/check_result.h"

#include <nlohmann/json.hpp>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string packed(const CheckResult& r) {
    Json evidence = Json::array();
    for (const auto& file : r.evidence) evidence.push_back(file.string());
    return Json::array(
               {r.name, r.state, r.line, r.seconds, r.details, evidence, r.drawn, r.reference_differs, r.numbers_wrong})
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

CheckResult unpacked(const std::string& text) {
    const Json j = Json::parse(text);
    CheckResult r{j[0], j[1], j[2], j[3], j[4], {}, j[6], j[7], j[8]};
    for (const Json& file : j[5]) r.evidence.emplace_back(file.get<std::string>());
    return r;
}

}  // namespace normalscope

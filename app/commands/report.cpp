#include "commands/report.h"

#include "core/base/decimal.h"

#include <embedded.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

void replace(std::string& text, std::string_view placeholder, const std::string& with) {
    if (const auto at = text.find(placeholder); at != std::string::npos) text.replace(at, placeholder.size(), with);
}

}  // namespace

std::string html_report(const std::string& title, const std::vector<CheckResult>& results) {
    Json checks = Json::array();
    for (const CheckResult& r : results) {
        Json check{{"name", r.name}, {"state", name(r.state)}, {"line", r.line}, {"seconds", r.seconds}};
        check.update(Json::parse(r.details));
        checks.push_back(std::move(check));
    }
    std::string data = Json{{"title", title}, {"checks", checks}}.dump(-1, ' ', false, Json::error_handler_t::replace);
    // Within a script element only "<" could end it.
    std::string safe;
    safe.reserve(data.size());
    for (const char c : data) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    std::string html(embedded::file("assets/report.html").value());
    replace(html, "@DATA@", safe);
    return html;
}

}  // namespace normalscope

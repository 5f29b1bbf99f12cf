#include "commands/report.h"

#include <embedded.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

std::string xml_text(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;  // XML has no way to write the others
        }
    }
    return out;
}

std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", seconds);
    return text;
}

std::size_t count(const std::vector<CheckResult>& results, const char* state) {
    return static_cast<std::size_t>(
        std::ranges::count_if(results, [&](const CheckResult& r) { return r.state == state; }));
}

void replace(std::string& text, std::string_view placeholder, const std::string& with) {
    if (const auto at = text.find(placeholder); at != std::string::npos) text.replace(at, placeholder.size(), with);
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<CheckResult>& results) {
    double total = 0.0;
    for (const CheckResult& r : results) total += r.seconds;
    const std::string counts = "tests=\"" + std::to_string(results.size()) + "\" failures=\"" +
                               std::to_string(count(results, "fail")) + "\" errors=\"" +
                               std::to_string(count(results, "error")) + "\" time=\"" + seconds_text(total) + "\"";
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts + ">\n  <testsuite name=\"" +
                      xml_text(suite) + "\" " + counts + ">\n";
    for (const CheckResult& r : results) {
        xml += "    <testcase classname=\"" + xml_text(suite) + "\" name=\"" + xml_text(r.name) + "\" time=\"" +
               seconds_text(r.seconds) + "\"";
        if (r.state == "pass")
            xml += "/>\n";
        else
            xml += ">\n      <" + std::string(r.state == "fail" ? "failure" : "error") + " message=\"" +
                   xml_text(r.line) + "\"/>\n    </testcase>\n";
    }
    return xml + "  </testsuite>\n</testsuites>\n";
}

std::string html_report(const std::string& title, const std::vector<CheckResult>& results) {
    Json checks = Json::array();
    for (const CheckResult& r : results) {
        Json check{{"name", r.name}, {"state", r.state}, {"line", r.line}, {"seconds", r.seconds}};
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

std::string base64(const std::string& bytes) {
    static constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t got = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < got ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= got ? kLetters[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace normalscope

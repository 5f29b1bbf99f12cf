#include "commands/junit.h"

#include "core/base/decimal.h"
#include "core/base/html.h"
#include "core/base/system.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>

namespace normalscope {

namespace {

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + xml_text(in_one_line(value)) + "\"";
}

std::string seconds_text(double seconds) { return with_decimals(seconds, 3); }

// In UTC, as the schema that services know wants it: without a zone.
std::string now() {
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    const auto day = std::chrono::floor<std::chrono::days>(now);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss time(now - day);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                  static_cast<int>(time.seconds().count()));
    return text.data();
}

std::string host() {
    std::string name = host_name();
    return name.empty() ? "localhost" : name;
}

std::string counts(const std::vector<CheckResult>& results) {
    const auto count = [&](CheckState state) {
        return std::to_string(std::ranges::count_if(results, [&](const CheckResult& r) { return r.state == state; }));
    };
    double total = 0.0;
    for (const CheckResult& r : results) total += r.seconds;
    return attribute("tests", std::to_string(results.size())) + attribute("failures", count(CheckState::Fail)) +
           attribute("errors", count(CheckState::Error)) + attribute("skipped", count(CheckState::Skipped)) +
           attribute("time", seconds_text(total));
}

std::string type_of(const CheckResult& r) {
    if (r.state == CheckState::Error) return "Error";
    if (r.reference_differs) return r.numbers_wrong ? "PictureAndNumbersDiffer" : "PictureDiffers";
    return "NumbersDiffer";
}

// As seen from where the program runs, which is where a service looks.
std::string attachments(const CheckResult& r) {
    std::string lines;
    for (const std::filesystem::path& file : r.evidence)
        lines += "[[ATTACHMENT|" +
                 xml_text(in_one_line(file.lexically_proximate(std::filesystem::current_path()).string())) + "]]\n";
    return lines.empty() ? lines : "      <system-out>" + lines + "</system-out>\n";
}

std::string outcome(const CheckResult& r) {
    if (r.state == CheckState::Skipped) return "      <skipped" + attribute("message", r.line) + "/>\n";
    const std::string tag = r.state == CheckState::Fail ? "failure" : "error";
    return "      <" + tag + attribute("message", r.line) + attribute("type", type_of(r)) + ">" +
           xml_text(in_one_line(r.line)) + "</" + tag + ">\n" + attachments(r);
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<CheckResult>& results) {
    const std::string all = counts(results);
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + all + ">\n  <testsuite" +
                      attribute("name", suite) + all + attribute("timestamp", now()) + attribute("hostname", host()) +
                      ">\n";
    for (const CheckResult& r : results) {
        xml += "    <testcase" + attribute("classname", suite) + attribute("name", r.name) +
               attribute("time", seconds_text(r.seconds));
        xml += r.state == CheckState::Pass ? "/>\n" : ">\n" + outcome(r) + "    </testcase>\n";
    }
    return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace normalscope

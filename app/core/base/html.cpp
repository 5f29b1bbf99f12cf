#include "core/base/html.h"

#include <array>

namespace normalscope {

namespace {

struct Name {
    std::string_view in_text, css_class;
};
constexpr std::array<Name, 5> kNames{
    {{"n_obj", ""}, {"v_obj", "tangent"}, {"n_world", "right"}, {"v_world", "tangent"}, {"n_naive", "naive"}}};

}  // namespace

std::string html_text(std::string_view utf8) {
    std::string html;
    for (const char c : utf8) switch (c) {
            case '&': html += "&amp;"; break;
            case '<': html += "&lt;"; break;
            case '>': html += "&gt;"; break;
            case '"': html += "&quot;"; break;
            default: html += c;
        }
    return html;
}

std::string html_math(std::string_view utf8) {
    std::string html;
    while (!utf8.empty()) {
        std::size_t at = utf8.size();
        const Name* found = nullptr;
        for (const Name& name : kNames)
            if (const auto there = utf8.find(name.in_text); there < at) {
                at = there;
                found = &name;
            }
        html += html_text(utf8.substr(0, at));
        if (!found) break;
        html += "<span" + (found->css_class.empty() ? "" : " class=\"" + std::string(found->css_class) + "\"") +
                "><i>" + std::string(found->in_text.substr(0, 1)) + "</i><sub>" +
                std::string(found->in_text.substr(2)) + "</sub></span>";
        utf8.remove_prefix(at + found->in_text.size());
    }
    return html;
}

}  // namespace normalscope

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

std::string xml_text(std::string_view utf8) {
    std::string text;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const std::string_view rest = utf8.substr(i, 3);
        const bool is_none = rest == "\uFFFE" || rest == "\uFFFF";
        const auto c = static_cast<unsigned char>(utf8[i]);
        const bool is_control = c < ' ' && c != '\n' && c != '\t';
        text += is_none || is_control ? "\uFFFD" : std::string(1, utf8[i]);
        i += is_none ? 2 : 0;
    }
    return html_text(text);
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

#include "commands/step_html.h"

#include "core/base/base64.h"
#include "core/base/html.h"
#include "core/base/math_text.h"
#include "core/image/png.h"

namespace normalscope {

std::string page_head(const std::string& title, std::string_view style, const std::string& more) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + html_text(title) +
           "</title>\n<style>" + std::string(style) + "</style>\n" + more + "</head>\n<body>\n";
}

std::string data_of(const Image& image) { return "data:image/png;base64," + base64(png_bytes(image)); }

std::string picture_html(const LessonStep& step, const std::string& source, const std::string& attributes) {
    return "  <img" + attributes + " alt=\"" + html_text(plain_math(step.caption)) + "\" src=\"" + source + "\">\n";
}

std::string equations_html(const LessonStep& step) {
    std::string html;
    for (const std::string& line : step.equations) html += "  <p class=\"equation\">" + html_math(line) + "</p>\n";
    if (!step.look_at.empty()) html += "  <p class=\"look\">" + html_math(step.look_at) + "</p>\n";
    return html;
}

std::string question_html(const Question& question) {
    std::string html = "  <p class=\"caption\">" + html_math(question.text) + "</p>\n  <ol class=\"choices\">\n";
    for (const Choice& choice : question.choices) html += "    <li>" + html_math(choice.text) + "</li>\n";
    return html + "  </ol>\n";
}

}  // namespace normalscope

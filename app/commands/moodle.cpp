#include "commands/moodle.h"

#include "core/base/base64.h"
#include "core/base/decimal.h"
#include "core/base/html.h"
#include "core/image/png.h"

#include <cmath>
#include <string_view>

namespace normalscope {

namespace {

std::string element(const std::string& tag, const std::string& words) {
    return "    <" + tag + "><text>" + xml_text(words) + "</text></" + tag + ">\n";
}
std::string html_element(const std::string& tag, const std::string& html, const std::string& more = "") {
    return "    <" + tag + " format=\"html\"><text>" + xml_text(html) + "</text>" + more + "</" + tag + ">\n";
}

// The name by which the words find their picture, which is kept apart for each question.
constexpr std::string_view kPicture = "picture.png";

std::string head(const MoodleItem& item, const std::string& more_html) {
    const std::string picture = "<p><img src=\"@@PLUGINFILE@@/" + std::string(kPicture) + "\" alt=\"" +
                                html_text(item.picture_says) + "\" width=\"" + std::to_string(item.picture.size.x) +
                                "\" height=\"" + std::to_string(item.picture.size.y) + "\"></p>";
    const std::string file = "<file name=\"" + std::string(kPicture) + "\" path=\"/\" encoding=\"base64\">" +
                             base64(png_bytes(item.picture)) + "</file>";
    return element("name", item.name) + html_element("questiontext", item.html + picture + more_html, file) +
           html_element("generalfeedback", item.why);
}

// What means something within {…}.
std::string cloze_text(std::string_view words) {
    std::string text;
    for (const char c : words) {
        if (std::string_view("}~#=/\"\\").find(c) != std::string_view::npos) text += '\\';
        text += c;
    }
    return text;
}

std::string decimals(double value) {
    return with_decimals(std::abs(value) < 5e-5 ? 0.0 : value, 4);  // never −0
}

// {1:NUMERICAL:=0.4472:0.02~%0%0.8944:0.02#…}
std::string cloze(const MoodleNumber& number) {
    const std::string tolerance = ":" + with_digits(number.tolerance, 3);
    std::string text = "{1:NUMERICAL:=" + decimals(number.right) + tolerance;
    if (std::abs(number.known_wrong - number.right) > 2.0 * number.tolerance)
        text += "~%0%" + decimals(number.known_wrong) + tolerance + "#" + cloze_text(html_text(number.because));
    return text + "}";
}

}  // namespace

void MoodleQuiz::category(const std::string& name) {
    std::string path = "$course$/top/Normalscope/";
    for (const char c : name) path += c == '/' ? "//" : std::string(1, c);  // else a category within it
    questions_ += "  <question type=\"category\">\n" + element("category", path) + "  </question>\n";
}

void MoodleQuiz::choices(const MoodleItem& item, const Question& question) {
    questions_ += "  <question type=\"multichoice\">\n" + head(item, "<p>" + html_math(question.text) + "</p>");
    questions_ +=
        "    <single>true</single>\n    <shuffleanswers>true</shuffleanswers>\n"
        "    <answernumbering>ABCD</answernumbering>\n";
    for (const Choice& choice : question.choices)
        questions_ += std::string("    <answer fraction=\"") + (choice.right ? "100" : "0") +
                      "\" format=\"html\"><text>" + xml_text(html_math(choice.text)) +
                      "</text><feedback format=\"html\"><text>" + xml_text(html_math(choice.because)) +
                      "</text></feedback></answer>\n";
    questions_ += "  </question>\n";
}

void MoodleQuiz::numbers(const MoodleItem& item, const std::vector<MoodleNumber>& numbers) {
    std::string places;
    for (const MoodleNumber& number : numbers) places += (places.empty() ? "(" : ", ") + cloze(number);
    questions_ += "  <question type=\"cloze\">\n" + head(item, "<p>" + places + ")</p>") + "  </question>\n";
}

std::string MoodleQuiz::text() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n" + questions_ + "</quiz>\n";
}

}  // namespace normalscope

#include "core/picture/svg_words.h"

#include "core/base/decimal.h"
#include "core/base/html.h"
#include "core/base/utf8.h"
#include "core/frame/solids.h"
#include "core/picture/contour.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

double letters(const std::string& utf8) { return static_cast<double>(columns(utf8)); }

/// The words of one pane.
class LabelWriter {
public:
    LabelWriter(const Pane& pane, const ThemeColors& colors, double scale)
        : pane_(pane), colors_(colors), scale_(scale) {}

    std::string text() {
        for (const Label& l : pane_.labels) label(l);
        return std::move(out_);
    }

private:
    void words(glm::dvec2 where, const std::string& text, double size, const std::string& more) {
        out_ += "  <text x=\"" + svg_number(where.x) + "\" y=\"" + svg_number(where.y) + "\" font-size=\"" +
                svg_number(size * scale_) + "\" " + more + ">" + html_text(text) + "</text>\n";
    }
    void label(const Label& label) {
        const glm::dvec2 where(label.pixel);
        if (label.role == Label::Role::Title) {
            const double y = pane_.rect.origin.y + 34.0 * scale_, width = 0.58 * 20.0 * scale_ * letters(label.text);
            out_ += "  <rect x=\"" + svg_number(where.x - width / 2 - 16 * scale_) + "\" y=\"" +
                    svg_number(y - 21 * scale_) + "\" width=\"" + svg_number(width + 32 * scale_) + "\" height=\"" +
                    svg_number(32 * scale_) + "\" rx=\"" + svg_number(16 * scale_) + "\" fill=\"" +
                    svg_color(label.color) + "\"/>\n";
            words({where.x, y + 2.5 * scale_}, label.text, 20.0,
                  "font-weight=\"600\" text-anchor=\"middle\" fill=\"#ffffff\" xml:space=\"preserve\"");
            return;
        }
        if (label.role == Label::Role::Side || label.role == Label::Role::Level) {
            const double size = label.role == Label::Role::Side ? 15.0 : 13.0;
            const glm::dvec2 half = scale_ * glm::dvec2(0.29 * size * letters(label.text) + 6.0, 0.7 * size);
            out_ += "  <rect x=\"" + svg_number(where.x - half.x) + "\" y=\"" + svg_number(where.y - half.y) +
                    "\" width=\"" + svg_number(2.0 * half.x) + "\" height=\"" + svg_number(2.0 * half.y) + "\" rx=\"" +
                    svg_number(4 * scale_) + "\" fill=\"" + svg_color(colors_.text_shadow) +
                    "\" fill-opacity=\"0.8\"/>\n";
            words(where + glm::dvec2(0, 0.35 * size * scale_), label.text, size,
                  "font-weight=\"600\" text-anchor=\"middle\" xml:space=\"preserve\" fill=\"" + svg_color(label.color) +
                      "\"");
            return;
        }
        const std::string halo =
            "stroke=\"" + svg_color(colors_.text_shadow) + "\" stroke-width=\"" + svg_number(3 * scale_) +
            "\" stroke-linejoin=\"round\" paint-order=\"stroke\" fill=\"" + svg_color(label.color) + "\"";
        if (label.role == Label::Role::Axis)
            words(where + glm::dvec2(0, 5 * scale_), label.text, 15.0,
                  "font-weight=\"600\" text-anchor=\"middle\" " + halo);
        else
            words(where + glm::dvec2(8 * scale_, 5 * scale_), label.text, label.role == Label::Role::Note ? 13.0 : 15.0,
                  "font-weight=\"600\" " + halo);
    }

    const Pane& pane_;
    const ThemeColors& colors_;
    double scale_;
    std::string out_;
};

}  // namespace

std::string svg_number(double v) { return with_decimals(v, 2); }
std::string svg_color(const glm::vec3& color) {
    std::string text = "#";
    for (const float channel : {color.r, color.g, color.b}) {
        const auto byte = static_cast<std::size_t>(std::lround(255.0f * std::clamp(channel, 0.0f, 1.0f)));
        for (const std::size_t digit : {byte / 16, byte % 16}) text += "0123456789abcdef"[digit];
    }
    return text;
}

std::string svg_labels(const Pane& pane, const ThemeColors& colors, double pixel_scale) {
    return LabelWriter(pane, colors, pixel_scale).text();
}

std::string svg_legend(const Frame& frame, double scale) {
    std::string out;
    const ThemeColors colors = theme_colors(frame.theme);
    double y =
        frame.rect.origin.y + frame.rect.size.y - (14.0 + 22.0 * static_cast<double>(frame.legend.size())) * scale;
    const double x = frame.rect.origin.x + 20.0 * scale;
    for (const LegendEntry& entry : frame.legend) {
        y += 22.0 * scale;
        const std::string color = svg_color(entry.color);
        const double middle = y - 5.0 * scale, tip = x + 34.0 * scale;
        const std::string dash = entry.kind == ArrowKind::Naive ? " stroke-dasharray=\"" + svg_number(4 * scale) + " " +
                                                                      svg_number(3 * scale) + "\""
                                                                : "";
        const bool hollow = entry.kind == ArrowKind::Object;
        const auto head = [&](double at) {
            return closed_path_data(
                {{at - 9 * scale, middle - 4.5 * scale}, {at, middle}, {at - 9 * scale, middle + 4.5 * scale}});
        };
        const double back = ArrowProportions::kToSecondHead * 9 * scale;
        const std::string heads = head(tip) + (entry.kind == ArrowKind::Cofactor ? head(tip - back) : "");
        out += "<path fill=\"none\" stroke=\"" + color + "\" stroke-width=\"" +
               svg_number((hollow ? 1.2 : 2.4) * scale) + "\"" + dash + " d=\"" +
               open_path_data({{x, middle}, {tip - 9 * scale, middle}}) + "\"/>\n<path " +
               (hollow ? "fill=\"none\" stroke=\"" + color + "\"" : "fill=\"" + color + "\"") + " d=\"" + heads +
               "\"/>\n<text x=\"" + svg_number(tip + 9 * scale) + "\" y=\"" + svg_number(y) + "\" font-size=\"" +
               svg_number(14 * scale) + "\" fill=\"" + svg_color(colors.text) + "\" xml:space=\"preserve\">" +
               html_text(entry.text) + "</text>\n";
    }
    return out;
}

}  // namespace normalscope

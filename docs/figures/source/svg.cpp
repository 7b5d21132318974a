#include "docs/figures/source/svg.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace rt::figures {

namespace {

/// The value with this many decimals. An exact half is rounded up even if the last bit is too low,
/// so that every compiler and mathematical library writes the same file.
std::string rounded(Real value, int decimals) {
    const Real unit = std::pow(Real(10), -decimals);
    const Real units = std::floor(value / unit + Real(0.5) + Real(1e-6));
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, units * unit + 0);  // + 0 makes −0 a 0
    return text;
}

std::string number(Real value) {
    std::string text = rounded(value, 2);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(std::string_view name, Real value) {
    return attribute(name, number(value));
}

std::string paint(std::string_view fill, const Pen& pen) {
    std::string text = attribute("fill", fill);
    if (pen.color == none) return text;
    text += attribute("stroke", pen.color) + attribute("stroke-width", pen.width);
    return pen.dashes.empty() ? text : text + attribute("stroke-dasharray", pen.dashes);
}

/// For each color of a figure, the color on a dark page.
std::string dark_style() {
    struct Dark {
        std::string_view light;
        std::string_view dark;
    };
    constexpr std::array colors = {
        Dark{white, "#0d1117"},  Dark{ink, "#e6edf3"},      Dark{gray, "#9da7b3"},
        Dark{faint, "#3b434d"},  Dark{tint, "#1b222b"},     Dark{blue, "#4da3e6"},
        Dark{red, "#f0694d"},    Dark{green, "#5fb878"},    Dark{amber, "#d99a2b"},
        Dark{purple, "#c792ea"}, Dark{pale_red, "#54271e"}, Dark{pale_blue, "#1d3a54"}};
    std::string text = "<style>@media (prefers-color-scheme:dark){";
    for (const auto& [light, dark] : colors)
        for (const std::string_view part : {"fill", "stroke"}) {
            const std::string name(part);
            text += "[" + name + "=\"" + std::string(light) + "\"]{" + name + ":" +
                    std::string(dark) + "}";
        }
    return text + "}</style>\n";
}

std::string list(const std::vector<Vec2>& points) {
    std::string text;
    for (const Vec2& p : points)
        text += (text.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    return attribute("points", text);
}

std::string_view word(Anchor anchor) {
    if (anchor == Anchor::start) return "start";
    return anchor == Anchor::middle ? "middle" : "end";
}

}  // namespace

Svg::Svg(Vec2 size, std::string_view title)
    : head_(
          "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", size.x) +
          attribute("height", size.y) +
          attribute("viewBox", "0 0 " + number(size.x) + " " + number(size.y)) +
          " xml:space=\"preserve\" role=\"img\" font-family=\"sans-serif\" stroke-linecap=\"round\""
          " stroke-linejoin=\"round\">\n<title>" +
          escaped(title) + "</title>\n" + dark_style()) {
    // A card, white or dark, whatever the page around it is.
    shapes_ = "<rect" + attribute("width", size.x) + attribute("height", size.y) +
              attribute("rx", 8) + attribute("fill", white) + "/>\n";
}

void Svg::line(Vec2 from, Vec2 to, const Pen& pen) {
    shapes_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
               attribute("y2", to.y) + paint(none, pen) + "/>\n";
}

void Svg::arrow(Vec2 from, Vec2 to, const Pen& pen) {
    const Vec2 along = normalize(to - from);
    const Vec2 across(-along.y, along.x);
    const Real length = 5 + 3 * pen.width;
    const Vec2 base = to - length * along;
    line(from, base, pen);
    polygon({to, base + Real(0.38) * length * across, base - Real(0.38) * length * across},
            pen.color, no_pen);
}

void Svg::polyline(const std::vector<Vec2>& points, const Pen& pen) {
    shapes_ += "<polyline" + list(points) + paint(none, pen) + "/>\n";
}

void Svg::polygon(const std::vector<Vec2>& points, std::string_view fill, const Pen& pen) {
    shapes_ += "<polygon" + list(points) + paint(fill, pen) + "/>\n";
}

void Svg::circle(Vec2 center, Real radius, std::string_view fill, const Pen& pen) {
    shapes_ += "<circle" + attribute("cx", center.x) + attribute("cy", center.y) +
               attribute("r", radius) + paint(fill, pen) + "/>\n";
}

void Svg::text(Vec2 point, std::string_view label, const TextStyle& style) {
    labels_ += "<text" + attribute("x", point.x) + attribute("y", point.y) +
               attribute("fill", style.color) + attribute("font-size", style.size) +
               (style.bold ? attribute("font-weight", "bold") : "") +
               attribute("text-anchor", word(style.anchor)) +
               // A white rim keeps the lines below out of the letters.
               " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\">";
    Real raised = 0;
    for (const Run& run : typeset(label)) {
        const Real raise = style.size * (run.script > 0 ? Real(0.36) : Real(0.22) * run.script);
        labels_ += "<tspan";
        if (raise != raised) labels_ += attribute("dy", raised - raise);
        if (run.script != 0) labels_ += attribute("font-size", style.size * Real(0.75));
        if (run.italic) labels_ += attribute("font-style", "italic");
        labels_ += ">" + escaped(run.text) + "</tspan>";
        raised = raise;
    }
    labels_ += "</text>\n";
}

std::string Svg::source() const {
    return head_ + shapes_ + labels_ + "</svg>\n";
}

std::string decimal(Real value, int decimals) {
    std::string text = rounded(value, decimals);
    return text.front() == '-' ? "−" + text.substr(1) : text;
}

namespace {

/// The bytes of the UTF-8 character at the text's beginning.
std::string_view first_character(std::string_view text) {
    std::size_t size = 1;
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) ++size;
    return text.substr(0, size);
}

bool is_letter(std::string_view character) {
    const char c = character.front();
    if (character.size() == 1) return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return character >= "α" && character <= "ω";
}

/// The letters at the beginning of the text, or else its first character.
std::string_view first_word(std::string_view text) {
    std::size_t size = 0;
    while (size < text.size() && is_letter(first_character(text.substr(size))))
        size += first_character(text.substr(size)).size();
    return size == 0 ? first_character(text) : text.substr(0, size);
}

bool is_symbol(std::string_view word) {
    return is_letter(first_character(word)) && first_character(word) == word;
}

void set_mathematics(std::string_view text, int script, std::vector<Run>& runs) {
    while (!text.empty()) {
        const char c = text.front();
        if (c == '_' || c == '^') {
            const bool group = text[1] == '{';
            const std::string_view inside =
                group ? text.substr(2, text.find('}') - 2) : first_character(text.substr(1));
            set_mathematics(inside, c == '_' ? -1 : 1, runs);
            text.remove_prefix(1 + inside.size() + (group ? 2 : 0));
            continue;
        }
        const std::string_view word = first_word(text);
        runs.push_back({.text = std::string(word), .italic = is_symbol(word), .script = script});
        text.remove_prefix(word.size());
    }
}

/// Joins neighbors with the same style.
std::vector<Run> joined(const std::vector<Run>& runs) {
    std::vector<Run> result;
    for (const Run& run : runs) {
        const bool alike = !result.empty() && result.back().italic == run.italic &&
                           result.back().script == run.script;
        if (alike)
            result.back().text += run.text;
        else
            result.push_back(run);
    }
    return result;
}

}  // namespace

std::vector<Run> typeset(std::string_view label) {
    std::vector<Run> runs;
    bool mathematics = false;
    while (true) {
        const std::size_t end = label.find('$');
        const std::string_view part = label.substr(0, end);
        if (mathematics)
            set_mathematics(part, 0, runs);
        else if (!part.empty())
            runs.push_back({.text = std::string(part)});
        if (end == std::string_view::npos) return joined(runs);
        label.remove_prefix(end + 1);
        mathematics = !mathematics;
    }
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += c;
    }
    return result;
}

}  // namespace rt::figures

#include "docs/figures/svg.hpp"

#include "common/input_error.hpp"

#include <array>
#include <cstdio>
#include <fstream>

namespace rt {

namespace {

/// Hundredths of a pixel: the same text on every machine.
std::string number(Real value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value == 0 ? 0 : value);
    return text.data();
}

std::string style(Look look) {
    switch (look) {
        case Look::line:
            return "stroke=\"#3b4252\" stroke-width=\"1.6\"";
        case Look::thin:
            return "stroke=\"#aab2c0\" stroke-width=\"1\"";
        case Look::dashed:
            return "stroke=\"#6b7487\" stroke-width=\"1.2\" stroke-dasharray=\"5 4\"";
        case Look::ray:
            return "stroke=\"#2b7ab8\" stroke-width=\"1.8\"";
        case Look::shape:
            return "stroke=\"#b5651d\" stroke-width=\"2\"";
        case Look::good:
            return "stroke=\"#2e8b57\" stroke-width=\"2\"";
        case Look::bad:
            return "stroke=\"#c0392b\" stroke-width=\"2\"";
    }
    return "";
}

std::string color(Look look) {
    const std::string all = style(look);
    return all.substr(8, 7);
}

/// Indices become small and low, angle brackets survive.
std::string marked_up(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '<')
            result += "&lt;";
        else if (text[i] == '_' && i + 1 < text.size())
            result += std::string("<tspan dy=\"3\" font-size=\"11\">") + text[++i] +
                      "</tspan><tspan dy=\"-3\">\u200b</tspan>";
        else
            result += text[i];
    }
    return result;
}

}  // namespace

Svg::Svg(Vec2 left_bottom, Vec2 right_top, Real scale)
    : left_bottom_(left_bottom), size_((right_top - left_bottom) * scale), scale_(scale) {}

std::string Svg::x(Vec2 point) const {
    return number((point.x - left_bottom_.x) * scale_);
}

std::string Svg::y(Vec2 point) const {
    return number(size_.y - (point.y - left_bottom_.y) * scale_);
}

std::string Svg::points(const std::vector<Vec2>& list) const {
    std::string text;
    for (const Vec2& point : list) text += x(point) + "," + y(point) + " ";
    return text;
}

void Svg::segment(Vec2 from, Vec2 to, Look look) {
    body_ += "<line x1=\"" + x(from) + "\" y1=\"" + y(from) + "\" x2=\"" + x(to) + "\" y2=\"" +
             y(to) + "\" " + style(look) + "/>\n";
}

void Svg::arrow(Vec2 from, Vec2 to, Look look) {
    segment(from, to, look);
    const Vec2 along = (to - from) / std::sqrt(glm::dot(to - from, to - from));
    const Vec2 back = to - along * (9 / scale_);
    const Vec2 aside = Vec2(-along.y, along.x) * (4 / scale_);
    body_ += "<polygon points=\"" + points({to, back + aside, back - aside}) + "\" fill=\"" +
             color(look) + "\"/>\n";
}

void Svg::circle(Vec2 center, Real radius, Look look) {
    body_ += "<circle cx=\"" + x(center) + "\" cy=\"" + y(center) + "\" r=\"" +
             number(radius * scale_) + "\" fill=\"none\" " + style(look) + "/>\n";
}

void Svg::polygon(const std::vector<Vec2>& corners, Look look) {
    body_ += "<polygon points=\"" + points(corners) + "\" fill=\"" + color(look) +
             "\" fill-opacity=\"0.15\" stroke-linejoin=\"round\" " + style(look) + "/>\n";
}

void Svg::path(const std::vector<Vec2>& list, Look look) {
    body_ += "<polyline points=\"" + points(list) + "\" fill=\"none\" " + style(look) + "/>\n";
}

void Svg::dot(Vec2 point, Look look) {
    body_ += "<circle cx=\"" + x(point) + "\" cy=\"" + y(point) + "\" r=\"3.5\" fill=\"" +
             color(look) + "\"/>\n";
}

void Svg::label(Vec2 point, const std::string& text, Vec2 offset) {
    const Vec2 place = point + offset / scale_;
    body_ += "<text x=\"" + x(place) + "\" y=\"" + y(place) + "\">" + marked_up(text) + "</text>\n";
}

void Svg::write(const std::string& file) const {
    const std::string size = "width=\"" + number(size_.x) + "\" height=\"" + number(size_.y) + "\"";
    std::ofstream out(file);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" " << size
        << " font-family=\"sans-serif\" font-size=\"14\" fill=\"#222\">\n"
        << "<rect " << size << " rx=\"8\" fill=\"#fdfdfb\"/>\n"
        << body_ << "</svg>\n";
    if (!out) throw InputError({file}, "cannot be written");
}

}  // namespace rt

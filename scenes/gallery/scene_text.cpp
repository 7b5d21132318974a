#include "scenes/gallery/scene_text.hpp"

#include "common/system/hash.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

namespace {

glm::dvec3 shown(std::uint32_t web_color) {
    return glm::dvec3(web_color >> 16U & 255U, web_color >> 8U & 255U, web_color & 255U) / 255.0;
}

/// The inverse of the curve of sRGB (IEC 61966-2-1).
double light(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

Light3 light(glm::dvec3 shown) {
    return {{light(shown.x), light(shown.y), light(shown.z)}};
}

}  // namespace

Light3 paint(std::uint32_t web_color) {
    return light(shown(web_color));
}

Light3 ramp(const std::vector<std::uint32_t>& palette, double share) {
    const double place = std::clamp(share, 0.0, 1.0) * double(palette.size() - 1);
    const std::size_t first = std::min(std::size_t(place), palette.size() - 2);
    const double second_share = place - double(first);
    return light(shown(palette[first]) * (1 - second_share) +
                 shown(palette[first + 1]) * second_share);
}

Light3 hue(double turn, double saturation, double value) {
    glm::dvec3 color(0);
    for (int i = 0; i < 3; ++i) {
        const double corner = std::fmod(5 - 2 * i + 6 * turn, 6.0);
        color[i] = value - value * saturation * std::clamp(std::min(corner, 4 - corner), 0.0, 1.0);
    }
    return light(color);
}

Light3 mix(const Light3& first, const Light3& second, double share) {
    return {first.rgb * (1 - share) + second.rgb * share};
}

double random_of(std::initializer_list<int> keys) {
    std::uint32_t bits = 0x9e3779b9U;
    for (const int key : keys) bits = mixed_bits(bits ^ std::uint32_t(key));
    return double(bits) / 4294967296.0;
}

SceneText& SceneText::comment(std::string_view words) {
    return line("# " + std::string(words));
}

SceneText& SceneText::line(std::string_view words) {
    if (!text_.empty()) text_ += '\n';
    text_ += words;
    return *this;
}

SceneText& SceneText::element(std::string_view keyword) {
    return line(keyword);
}

SceneText& SceneText::operator<<(double number) {
    text_ += ' ';
    add(number);
    return *this;
}

SceneText& SceneText::operator<<(glm::dvec3 point) {
    *this << point.x;
    text_ += ',';
    add(point.y);
    text_ += ',';
    add(point.z);
    return *this;
}

SceneText& SceneText::operator<<(const Light3& color) {
    const auto level = [](double value) {
        return std::to_string(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    };
    text_ += ' ' + level(color.rgb.x) + ',' + level(color.rgb.y) + ',' + level(color.rgb.z);
    return *this;
}

SceneText& SceneText::operator<<(const char* words) {
    text_ += ' ';
    text_ += words;
    return *this;
}

SceneText& SceneText::option(std::string_view key, double value) {
    text_ += ' ';
    text_ += key;
    add(value);
    return *this;
}

void SceneText::add(double number) {
    const long thousandths = std::lround(number * 1000);
    if (thousandths < 0) text_ += '-';
    const std::string digits = std::to_string(std::labs(thousandths) + 1000);
    const std::string whole = std::to_string(std::labs(thousandths) / 1000);
    std::string fraction = digits.substr(digits.size() - 3);
    fraction.erase(fraction.find_last_not_of('0') + 1);
    text_ += fraction.empty() ? whole : whole + '.' + fraction;
}

}  // namespace rt

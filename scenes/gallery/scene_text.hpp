// The text of a scene, element by element, and what its pictures are composed of: colors from a
// palette, and numbers that look random.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The vector's direction, of length 1.
[[nodiscard]] inline glm::dvec3 unit(glm::dvec3 v) {
    return v / std::hypot(v.x, v.y, v.z);
}

/// A color as light: what `--gamma srgb` shows as the color that a palette names.
struct Light3 {
    glm::dvec3 rgb;  ///< 0 to 1
};

/// The color of a palette, given as on the web: 0xe2483a.
[[nodiscard]] Light3 paint(std::uint32_t web_color);

/// The color at `share`, 0 to 1, of a palette; between its colors, a mixture.
[[nodiscard]] Light3 ramp(const std::vector<std::uint32_t>& palette, double share);

/// The color of a hue, 0 to 1 around the color wheel.
[[nodiscard]] Light3 hue(double turn, double saturation, double value);

[[nodiscard]] Light3 mix(const Light3& first, const Light3& second, double share);

/// A number from 0 to 1 that depends on the keys alone, and looks random.
[[nodiscard]] double random_of(std::initializer_list<int> keys);

/// The lines of a scene. Numbers have three decimals at most.
class SceneText {
public:
    /// Begins a line: `# words`.
    SceneText& comment(std::string_view words);
    /// Adds a line of the words, as they are.
    SceneText& line(std::string_view words);
    /// Begins an element: its keyword.
    SceneText& element(std::string_view keyword);

    // Fields of the element.
    SceneText& operator<<(double number);
    SceneText& operator<<(glm::dvec3 point);
    SceneText& operator<<(const Light3& color);
    SceneText& operator<<(const char* words);
    SceneText& option(std::string_view key, double value);

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    void add(double number);

    std::string text_;
};

}  // namespace rt

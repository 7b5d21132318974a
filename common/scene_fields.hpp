// The fields of an element as values: checked, and in the units of common/scene.hpp.
#pragma once

#include "common/decimal.hpp"
#include "common/element_line.hpp"
#include "common/scene.hpp"

#include <string_view>
#include <utility>

namespace rt::inline RT_PRECISION {

/// Each function takes the next field, whose name it is given. They throw InputError, with the
/// place of the token, if it is missing or not what it must be.
class Fields : public ElementLine {
public:
    Fields(Line line, const ElementForm& form, SceneReport& report, Axes axes)
        : ElementLine(std::move(line), form, report), axes_(axes) {}

    /// In our axes.
    [[nodiscard]] Vec3 point(std::string_view field);

    /// In our axes, made unit length. If it is zero, lenient reading leaves out the shape.
    [[nodiscard]] Vec3 direction(std::string_view field);

    /// Whether the shape has a direction that is zero: no ray could meet it.
    [[nodiscard]] bool is_left_out() const { return left_out_; }

    /// In our axes, made unit length, or zero.
    [[nodiscard]] Vec3 camera_direction(std::string_view field);

    /// A positive number, whose half is positive too.
    [[nodiscard]] Real length(std::string_view field);

    /// Three positive numbers.
    [[nodiscard]] Vec3 lengths(std::string_view field);

    /// 0 to 1.
    [[nodiscard]] Real ratio(std::string_view field);

    /// A word as it stands: a file's name.
    [[nodiscard]] std::string word(std::string_view field);

    // Options, and what they are if the line has none.
    [[nodiscard]] Real ratio_option(std::string_view key, Real otherwise);
    [[nodiscard]] Real length_option(std::string_view key, Real otherwise);
    [[nodiscard]] Vec3 direction_option(std::string_view key, Vec3 otherwise);  ///< in its axes

    /// 0 to 180 degrees as radians, less than π. 60 degrees, with a warning, if lenient reading
    /// finds nothing.
    [[nodiscard]] Real angle(std::string_view field);

    /// 0 to 255 as 0 to 1. Lenient reading skips what stands before it, and keeps fractions; a word
    /// in its place, of a texture say, is white.
    [[nodiscard]] Color color();

    /// color(), or white, with a warning, if lenient reading finds nothing at all.
    [[nodiscard]] Color color_or_white();

    /// A number of pixels, positive, clipped at largest_side with a warning.
    [[nodiscard]] int pixels(std::string_view field);

private:
    struct Triple {
        std::array<Token, 3> parts;
        std::array<Decimal, 3> numbers;
        Vec3 value;
    };

    [[nodiscard]] Decimal decimal(Token token, const std::string& name);
    [[nodiscard]] Triple triple(std::string_view field);
    [[nodiscard]] Triple triple_of(const std::array<Token, 3>& parts, std::string_view field);
    [[noreturn]] void refuse_zero(const Triple& triple, std::string_view field) const;
    [[nodiscard]] Vec3 direction_of(const Triple& triple, std::string_view field);
    [[nodiscard]] std::optional<Vec3> unit_direction(const Triple& triple, std::string_view field);
    [[nodiscard]] Real length_of(Token token, const std::string& name);
    [[nodiscard]] Real up_to(int bound, Token token, std::string_view field);
    [[nodiscard]] bool word_for_color();

    Axes axes_;
    bool left_out_ = false;
};

/// Of a picture, in pixels. A larger one is more likely a slip than a wish: 8192 × 8192 pixels are
/// already 1.6 GB of double colours.
inline constexpr int largest_side = 8192;

}  // namespace rt::inline RT_PRECISION

// The fields of an element as checked values, in the units of common/scene/scene.hpp.
#pragma once

#include "common/scene/scene.hpp"
#include "common/scene_file/decimal.hpp"
#include "common/scene_file/element_line.hpp"

#include <string_view>
#include <utility>

namespace rt {
inline namespace RT_PRECISION {

/// Reads typed fields. Each function consumes the next field, whose name for messages is the
/// argument. Throws InputError with the location of the token if the field is missing or invalid.
class Fields : public ElementLine {
public:
    Fields(Line line, const ElementForm& form, SceneReport& report, Axes axes)
        : ElementLine(std::move(line), form, report), axes_(axes) {}

    /// A point, converted to the program's axes.
    [[nodiscard]] Vec3 point(std::string_view field);

    /// A unit direction in the program's axes. If the vector is zero, lenient reading leaves the
    /// shape out.
    [[nodiscard]] Vec3 direction(std::string_view field);

    /// Returns whether the shape is left out because a direction or a length of it is zero: no ray
    /// could hit it.
    [[nodiscard]] bool is_left_out() const { return left_out_; }

    /// A unit direction in the program's axes, or zero.
    [[nodiscard]] Vec3 camera_direction(std::string_view field);

    /// A positive length whose half is positive too. If it is zero, lenient reading leaves the
    /// shape out.
    [[nodiscard]] Real length(std::string_view field);

    /// Three such lengths.
    [[nodiscard]] Vec3 lengths(std::string_view field);

    /// A number from 0 to 1. Lenient reading takes the nearest of these for any other.
    [[nodiscard]] Real ratio(std::string_view field);

    /// The name of a file. Throws InputError if it seems to have several words.
    [[nodiscard]] std::string file(std::string_view field);

    /// Returns whether triples follow where another program's layout has them, and this one a
    /// number. Lenient reading then ignores the line.
    [[nodiscard]] bool is_other_layout(std::string_view number);

    // Options; `otherwise` is the value if the line does not have the option, or if a length is
    // zero.
    [[nodiscard]] Real ratio_option(std::string_view key, Real otherwise);
    [[nodiscard]] Real length_option(std::string_view key, Real otherwise);
    [[nodiscard]] Vec3 direction_option(std::string_view key,
                                        Vec3 otherwise);  ///< in the axes of the file

    /// An angle of 0 to 180 degrees, returned in radians, less than π. Lenient reading takes the
    /// nearest of these for any other, and 60 degrees if the field is missing.
    [[nodiscard]] Real angle(std::string_view field);

    /// A color of components 0 to 255, returned as 0 to 1. Lenient reading skips words before it,
    /// takes the nearest component for one beyond, and accepts fractions and `#rrggbb`. A word in
    /// its place, such as the name of a texture, becomes white.
    [[nodiscard]] Color color(std::string_view field = "color");

    /// As color(), but if the field is missing, lenient reading warns and returns white.
    [[nodiscard]] Color color_or_white();

    /// A positive number of pixels; a value above largest_side is clamped, with a warning. If it is
    /// zero or missing, lenient reading warns that the line is ignored, and returns nothing.
    [[nodiscard]] std::optional<int> pixels(std::string_view field);

private:
    /// A field of three numbers: its words, their digits, and their values.
    struct Triple {
        std::array<Token, 3> parts;
        std::array<Decimal, 3> numbers;
        Vec3 value;
    };

    [[nodiscard]] Decimal decimal(Token token, const std::string& name);
    [[nodiscard]] Real real(const Decimal& number, Token token, const std::string& name) const;
    [[nodiscard]] Triple triple(std::string_view field);
    [[nodiscard]] Triple triple_of(const std::array<Token, 3>& parts, std::string_view field);
    /// A unit direction in the file's axes. One that is zero leaves the shape out.
    [[nodiscard]] Vec3 direction_of(const Triple& triple, std::string_view field);
    [[nodiscard]] std::optional<Vec3> unit_direction(const Triple& triple, std::string_view field);
    [[nodiscard]] Real length_of(Token token, const std::string& name);
    [[nodiscard]] std::optional<Real> positive_length(Token token, const std::string& name,
                                                      const std::string& remedy);
    [[nodiscard]] Real up_to(int bound, Token token, const std::string& name);
    [[nodiscard]] Real up_to(int bound, const Decimal& number, Token token,
                             const std::string& name);
    [[nodiscard]] Color hexadecimal_color(std::string_view field);
    [[nodiscard]] bool word_for_color(std::string_view field);

    Axes axes_;
    bool left_out_ = false;
};

}  // namespace RT_PRECISION
}  // namespace rt

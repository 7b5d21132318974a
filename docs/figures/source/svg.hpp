// A page of vector graphics, written down as SVG.
#pragma once

#include "common/math/real.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt::figures {

// Colors that a reader can distinguish, with the same meaning in every figure. Each has a dark
// twin (svg.cpp), for readers who prefer a dark page.
inline constexpr std::string_view none = "none";
inline constexpr std::string_view white = "#ffffff";
inline constexpr std::string_view ink = "#24292f";     ///< shapes, text
inline constexpr std::string_view gray = "#68707a";    ///< construction lines, rejected parts
inline constexpr std::string_view faint = "#d3d9e0";   ///< grids, grounds
inline constexpr std::string_view tint = "#edf2f7";    ///< the inside of a shape
inline constexpr std::string_view blue = "#1f6bad";    ///< rays
inline constexpr std::string_view red = "#c23b22";     ///< hits
inline constexpr std::string_view green = "#35784a";   ///< normals, bases
inline constexpr std::string_view amber = "#a86500";   ///< light
inline constexpr std::string_view purple = "#7a3b99";  ///< misprints of a document, what is wrong
inline constexpr std::string_view pale_blue = "#d5e5f3";
inline constexpr std::string_view pale_red = "#f6dcd6";

struct Pen {
    std::string_view color = ink;
    Real width = 1.5;
    std::string_view dashes = "";  ///< lengths of dashes and gaps: "5 4"
};

inline constexpr Pen no_pen{.color = none};
inline constexpr Pen thin{.color = gray, .width = 1};
inline constexpr Pen dashed{.color = gray, .width = 1, .dashes = "4 4"};

enum class Anchor { start, middle, end };

struct TextStyle {
    std::string_view color = ink;
    Anchor anchor = Anchor::middle;
    Real size = 14;
    bool bold = false;
};

/// Points are pixels from the page's top left corner, y down.
class Svg {
public:
    /// The title is for readers who cannot see the figure.
    Svg(Vec2 size, std::string_view title);

    void line(Vec2 from, Vec2 to, const Pen& pen = {});
    void arrow(Vec2 from, Vec2 to, const Pen& pen = {});
    void polyline(const std::vector<Vec2>& points, const Pen& pen = {});
    void polygon(const std::vector<Vec2>& points, std::string_view fill, const Pen& pen = {});
    void circle(Vec2 center, Real radius, std::string_view fill, const Pen& pen = {});

    /// The label with its base line at the point, over everything else. Between two $ it is set as
    /// mathematics: "_" lowers and "^" raises the next letter or {group}, and a single letter is
    /// italic.
    void text(Vec2 point, std::string_view label, const TextStyle& style = {});

    [[nodiscard]] std::string source() const;

private:
    std::string head_;
    std::string shapes_;
    std::string labels_;
};

/// The value with this many decimals, in print: "−0.50".
[[nodiscard]] std::string decimal(Real value, int decimals);

// Labels with the course's mathematical notation.

/// Text in one position and one slant.
struct Run {
    std::string text;
    bool italic = false;
    int script = 0;  ///< −1 below the line, +1 above it
};

/// The label cut into runs. Between two $, "_" lowers and "^" raises the next letter or {group},
/// and a single letter is italic: "$o_r$", "$t_{min}$ > 0".
[[nodiscard]] std::vector<Run> typeset(std::string_view label);

/// The text with the special characters of XML as entities.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace rt::figures

// What stands on docs/accuracy.md and beside it, made of what the studies have measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt::accuracy {

/// A file beside the tables' page, and its text.
struct Plot {
    std::string name;  ///< "step03_sphere_cost": of an SVG file
    std::string source;
};

/// A part of the page.
struct Table {
    std::string name;  ///< what the page's marker calls it
    std::string text;  ///< Markdown
};

/// What is made of one study's files, which stand in the folder.
struct Study {
    std::vector<Plot> plots;
    std::vector<Table> tables;
};

/// "2·10⁻¹⁶", and "exact" of 0.
[[nodiscard]] std::string power(double value);

/// "10⁻¹⁶".
[[nodiscard]] std::string power_of_ten(int exponent);

/// Two digits, as print sets them: "0.015", "1.5", "150".
[[nodiscard]] std::string two_digits(double value);

/// "12,345": whole, as print sets it.
[[nodiscard]] std::string thousands(double value);

[[nodiscard]] Study shapes(const std::filesystem::path& folder);
[[nodiscard]] Study contact(const std::filesystem::path& folder);
[[nodiscard]] Study penumbra(const std::filesystem::path& folder);
[[nodiscard]] Study mirrors(const std::filesystem::path& folder);
[[nodiscard]] Study meshes(const std::filesystem::path& folder);
[[nodiscard]] Study pictures(const std::filesystem::path& folder);
[[nodiscard]] Study input_rounding(const std::filesystem::path& folder);
[[nodiscard]] Study choices(const std::filesystem::path& folder);

}  // namespace rt::accuracy

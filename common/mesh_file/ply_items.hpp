// The items of a PLY file's elements, one after the other, as text or as bytes. Both classes have
// the same functions, and are copied to return to an element.
#pragma once

#include "common/mesh_file/mesh_builder.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/mesh_file/ply_header.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rt {

/// Items as text, one on each line.
class PlyText {
public:
    static constexpr bool are_lines = true;

    explicit PlyText(MeshLines lines) : lines_(std::move(lines)) {}

    /// The number of items for which there may be enough text.
    [[nodiscard]] std::uint64_t most_items() const { return lines_.left() / 2 + 1; }

    /// Goes to the next item of the element. Throws InputError at the end of the file.
    void begin(const PlyElement& element, std::uint64_t index);
    /// Throws InputError if the item has more words than the element has properties.
    void end(const PlyElement& element);

    /// Returns the next value. Throws InputError if float cannot represent it.
    double number(const PlyElement& element, PlyType type);
    /// As number, but NaN and infinity are NaN.
    double number_or_nan(const PlyElement& element, PlyType type);
    std::int64_t whole_number(const PlyElement& element, PlyType type);
    /// Skips a value.
    void skip(const PlyElement& element, PlyType type);
    void skip_all(const PlyElement& element);
    /// Warns if an item follows the last element.
    void warn_of_rest(MeshBuilder& builder);

    /// Throws InputError at the current item.
    [[noreturn]] void refuse(const std::string& message) const { lines_.refuse(message); }

private:
    /// Returns the next line that is no comment.
    std::optional<std::string_view> next_line();
    /// Throws InputError for a value that is missing or no number.
    [[noreturn]] void refuse_value(const PlyElement& element) const;

    MeshLines lines_;
    std::string_view line_;  ///< the item
    std::string_view rest_;  ///< the values that were not taken
};

/// Items as bytes.
class PlyBytes {
public:
    static constexpr bool are_lines = false;

    PlyBytes(std::string_view bytes, std::endian order, std::string file)
        : bytes_(bytes), swap_(order != std::endian::native), file_(std::move(file)) {}

    [[nodiscard]] std::uint64_t most_items() const { return bytes_.size(); }

    void begin(const PlyElement&, std::uint64_t) {}
    void end(const PlyElement&) {}
    double number(const PlyElement&, PlyType type);
    double number_or_nan(const PlyElement& element, PlyType type) { return number(element, type); }
    std::int64_t whole_number(const PlyElement&, PlyType type);
    void skip(const PlyElement&, PlyType type) { take(type.size); }
    void skip_all(const PlyElement& element);
    void warn_of_rest(MeshBuilder& builder) const;

    [[noreturn]] void refuse(const std::string& message) const;

private:
    /// Removes the next bytes. Throws InputError at the end of the file.
    std::string_view take(std::size_t count);

    std::string_view bytes_;
    bool swap_;
    std::string file_;
};

/// Skips a number, or a list.
template <class Items>
void skip_property(Items& items, const PlyElement& element, const PlyProperty& property) {
    const std::int64_t count = property.length ? items.whole_number(element, *property.length) : 1;
    for (std::int64_t i = 0; i < count; ++i) items.skip(element, property.type);
}

}  // namespace rt

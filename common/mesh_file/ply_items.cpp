#include "common/mesh_file/ply_items.hpp"

#include "common/system/escaping.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace rt {

namespace {

bool has_list(const PlyElement& element) {
    return std::ranges::any_of(element.properties,
                               [](const PlyProperty& p) { return p.length.has_value(); });
}

template <class Number>
Number number_in(std::string_view bytes, bool swap) {
    std::array<char, sizeof(Number)> copy;
    std::memcpy(copy.data(), bytes.data(), sizeof(Number));
    if (swap) std::reverse(copy.begin(), copy.end());
    return std::bit_cast<Number>(copy);
}

}  // namespace

std::optional<std::string_view> PlyText::next_line() {
    auto line = lines_.next();
    while (line && line->starts_with("comment")) line = lines_.next();
    return line;
}

void PlyText::begin(const PlyElement& element, std::uint64_t index) {
    const auto line = next_line();
    if (!line) lines_.refuse_end(index, element.count, items_of(element));
    line_ = *line;
    rest_ = *line;
}

void PlyText::end(const PlyElement& element) {
    if (has_list(element) || count_words(rest_) == 0) return;
    refuse_value(element);
}

void PlyText::refuse_value(const PlyElement& element) const {
    const std::string owner = element.name == "vertex" ? "a vertex" : "a " + element.name;
    const std::size_t properties = element.properties.size();
    const std::size_t words = count_words(line_);
    if (!has_list(element) && words != properties) {
        lines_.refuse(owner + " has " + std::to_string(properties) +
                      " numbers here, on a line of its own, not " + std::to_string(words));
    }
    std::string_view rest = rest_;
    const std::string_view word = take_word(rest);
    if (word.empty())
        lines_.refuse(owner + " ends after " + std::to_string(words) + " numbers of its line");
    lines_.refuse("expected a number in the range of float, or an existing vertex, not " +
                  rt::quoted(word));
}

double PlyText::number(const PlyElement& element, PlyType) {
    const auto value = take_number(rest_);
    if (!value) refuse_value(element);
    return *value;
}

double PlyText::number_or_nan(const PlyElement& element, PlyType) {
    const auto value = take_number_or_nan(rest_);
    if (!value) refuse_value(element);
    return *value;
}

std::int64_t PlyText::whole_number(const PlyElement& element, PlyType) {
    const auto value = take_whole_number(rest_);
    if (!value) refuse_value(element);
    return *value;
}

void PlyText::skip(const PlyElement& element, PlyType) {
    if (take_word(rest_).empty()) refuse_value(element);
}

void PlyText::skip_all(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) begin(element, i);
}

void PlyText::warn_of_rest(MeshBuilder& builder) {
    if (next_line())
        builder.warn("the header counts no more items: what follows is not read", lines_.number());
}

std::string_view PlyBytes::take(std::size_t count) {
    if (count > bytes_.size()) throw InputError({file_}, "the file ends too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
}

double PlyBytes::number(const PlyElement& element, PlyType type) {
    if (!type.is_float) return double(whole_number(element, type));
    const std::string_view bytes = take(type.size);
    return type.size == 4 ? double(number_in<float>(bytes, swap_))
                          : number_in<double>(bytes, swap_);
}

std::int64_t PlyBytes::whole_number(const PlyElement&, PlyType type) {
    const std::string_view bytes = take(type.size);
    switch (type.size) {
        case 1:
            return type.is_signed ? number_in<std::int8_t>(bytes, false)
                                  : std::int64_t(number_in<std::uint8_t>(bytes, false));
        case 2:
            return type.is_signed ? number_in<std::int16_t>(bytes, swap_)
                                  : std::int64_t(number_in<std::uint16_t>(bytes, swap_));
        default:
            return type.is_signed ? number_in<std::int32_t>(bytes, swap_)
                                  : std::int64_t(number_in<std::uint32_t>(bytes, swap_));
    }
}

void PlyBytes::skip_all(const PlyElement& element) {
    if (!has_list(element)) {
        std::uint64_t size = 0;
        for (const PlyProperty& p : element.properties) size += p.type.size;
        if (size > 0 && element.count > bytes_.size() / size) take(bytes_.size() + 1);
        take(element.count * size);
        return;
    }
    for (std::uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& p : element.properties) skip_property(*this, element, p);
}

void PlyBytes::warn_of_rest(MeshBuilder& builder) const {
    if (bytes_.empty()) return;
    builder.warn("the header counts no more items: the last " +
                 (bytes_.size() == 1 ? "byte is" : std::to_string(bytes_.size()) + " bytes are") +
                 " not read");
}

void PlyBytes::refuse(const std::string& message) const {
    throw InputError({file_}, message);
}

}  // namespace rt

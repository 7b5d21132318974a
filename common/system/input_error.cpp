#include "common/system/input_error.hpp"

#include <algorithm>

namespace rt {

namespace {

/// A file name may contain a line break or a terminal's control sequence; a message is one plain
/// line.
std::string one_line(std::string text) {
    const auto is_control = [](unsigned char c) { return c < ' ' || c == '\x7f'; };
    std::replace_if(text.begin(), text.end(), is_control, '?');
    return text;
}

}  // namespace

std::string to_string(const FileLocation& place) {
    if (place.file.empty()) return "";
    std::string text = one_line(place.file) + ":";
    if (place.line > 0) text += std::to_string(place.line) + ":";
    if (place.column > 0) text += std::to_string(place.column) + ":";
    return text + " ";
}

InputError::InputError(const FileLocation& place, const std::string& message)
    : std::runtime_error(to_string(place) + "error: " + one_line(message)) {}

InputError::InputError(const std::string& text) : std::runtime_error(text) {}

InputError InputError::with(const std::string& remark) const {
    return InputError(what() + (" (" + one_line(remark) + ")"));
}

}  // namespace rt

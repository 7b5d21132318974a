#include "common/system/input_error.hpp"

#include "common/system/escaping.hpp"

namespace rt {

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

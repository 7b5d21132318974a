#include "common/input_error.hpp"

namespace rt {

std::string to_string(const Place& place) {
    if (place.file.empty()) return "";
    std::string text = place.file + ":";
    if (place.line > 0) text += std::to_string(place.line) + ":";
    if (place.column > 0) text += std::to_string(place.column) + ":";
    return text + " ";
}

InputError::InputError(const Place& place, const std::string& message)
    : std::runtime_error(to_string(place) + "error: " + message) {}

}  // namespace rt

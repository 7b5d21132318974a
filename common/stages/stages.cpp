#include "common/stages/stages.hpp"

#include <charconv>

namespace rt {

namespace {

std::optional<int> number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (value < 1 || value > static_cast<int>(stage_names.size())) return std::nullopt;
    return value;
}

}  // namespace

std::optional<int> find_stage(std::string_view text) {
    for (int stage = 1; stage <= static_cast<int>(stage_names.size()); ++stage)
        if (text == stage_name(stage) || text == topic_of(stage)) return stage;
    if (text.substr(0, 4) == "step") text.remove_prefix(4);
    return number(text);
}

}  // namespace rt

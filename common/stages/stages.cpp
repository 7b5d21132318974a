#include "common/stages/stages.hpp"

#include <algorithm>
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

std::optional<std::set<int>> find_stages(std::string_view text) {
    std::set<int> stages;
    for (;;) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view part = text.substr(0, comma);
        const std::size_t dash = part.find('-');
        const std::optional<int> first = find_stage(part.substr(0, dash));
        const std::optional<int> last =
            dash == std::string_view::npos ? first : find_stage(part.substr(dash + 1));
        if (!first || !last || *first > *last) return std::nullopt;
        for (int stage = *first; stage <= *last; ++stage) stages.insert(stage);
        if (comma == text.size()) return stages;
        text.remove_prefix(comma + 1);
    }
}

}  // namespace rt

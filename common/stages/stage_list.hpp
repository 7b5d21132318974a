// Lists of stages, as options name them.
#pragma once

#include <optional>
#include <set>
#include <string_view>

namespace rt {

/// The stages that "1-5,9,mirror" names, each as find_stage reads it; nothing for other text, or
/// for a range that is not in order.
[[nodiscard]] std::optional<std::set<int>> find_stages(std::string_view text);

}  // namespace rt

// Additions to the report of a failure.
#pragma once

#include <functional>
#include <string>

namespace rt {

/// Returns lines for the end of a failure, or an empty text. If there are lines, the failure's line
/// to paste is left out, since it would belong to another query.
inline std::function<std::string()> remark_on_failure;

}  // namespace rt

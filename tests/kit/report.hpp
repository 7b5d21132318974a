// What a report says of a failure besides the suite's own words.
#pragma once

#include <functional>
#include <string>

namespace rt {

/// Lines for the end of a failure, if there are any: then its line to paste, which would be of
/// another question, is left out.
inline std::function<std::string()> remark_on_failure;

}  // namespace rt

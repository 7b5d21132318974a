// What a student's object defines that is not his to define.
#pragma once

#include <string>
#include <string_view>

namespace rt::grade {

/// A sentence on the first of such symbols in what `nm -g -P` lists; nothing if there is none. It
/// explains, and keeps nobody out: that is the seal's.
[[nodiscard]] std::string foreign_symbol(std::string_view listed);

}  // namespace rt::grade

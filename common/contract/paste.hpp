// A failing call as a line of a suite, to be pasted.
#pragma once

#include "common/contract/smallest.hpp"

namespace rt::contract {

/// "CHECK(hits(Ray{…}, Sphere{…}, 4));"
[[nodiscard]] std::string paste_line(const Call& call, const Value& expected);

/// "a hit at t = 4", "no hit", "{0, 0, 1}", "your code crashed: Segmentation fault"
[[nodiscard]] std::string answer_text(const Call& call, const Answer& answer);

}  // namespace rt::contract

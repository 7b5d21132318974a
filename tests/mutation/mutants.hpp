// Typical slips in a source: mutants with one change each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mutation {

struct Mutant {
    std::string source;    ///< all of it, with the change
    int line = 0;          ///< of the change
    std::string function;  ///< the function that contains it, or the constant's name
    std::string before;    ///< the changed lines as they were, on one line, without comments
    std::string after;     ///< the unchanged line
};

/// Every change to the bodies of functions and to constants that reads as another program:
/// operators exchanged, terms and factors left out, signs, numbers, components, conditions,
/// arguments, calls and assignments. Some do not compile.
[[nodiscard]] std::vector<Mutant> mutants_of(std::string_view source);

}  // namespace mutation

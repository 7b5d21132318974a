// The known surviving mutants, and the reasons.
#pragma once

#include "tests/mutation/mutants.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace mutation {

struct Survivor {
    std::string stage;
    std::string function;
    std::string before;
    std::string after;
    std::string kind;  ///< "equivalent": as right as the reference; "accuracy": only less exact
    std::string reason;
};

/// A file of blocks:
///
///     step05_triangle normal
///     - the line
///     + the changed line
///     equivalent: the reason, for all the changes above it
///
/// Throws std::runtime_error for anything else.
[[nodiscard]] std::vector<Survivor> read_survivors(const std::filesystem::path& file);

/// The one that a mutant is, or null.
[[nodiscard]] const Survivor* find(const std::vector<Survivor>& survivors, const std::string& stage,
                                   const Mutant& mutant);

}  // namespace mutation

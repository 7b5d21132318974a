// Properties that random cases must have, and the plainest counterexample.
#pragma once

#include "tests/kit/random.hpp"
#include "tests/kit/verdict.hpp"

#include <functional>

namespace rt {

/// Tests one random case.
using Property = std::function<Verdict(Random&)>;

/// Passes if the property is true for every case. Otherwise reports the case that remains after
/// making the failing case's choices as plain as possible, and the seed (seed.hpp) unless it is
/// secret.
[[nodiscard]] Verdict for_all(const Property& property, int cases = 300);

/// True while this thread tests a random case.
[[nodiscard]] bool is_drawn();

}  // namespace rt

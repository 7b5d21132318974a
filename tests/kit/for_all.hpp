// What must hold of random cases, and the plainest case in which it does not.
#pragma once

#include "tests/kit/random.hpp"
#include "tests/kit/verdict.hpp"

#include <functional>

namespace rt {

/// Asks about one random case.
using Property = std::function<Verdict(Random&)>;

/// Holds if the property holds of every case. Else tells the case that is left when the choices
/// that made the failing one are made as plain as they can be, and the seed (seed.hpp) unless it is
/// secret.
[[nodiscard]] Verdict for_all(const Property& property, int cases = 300);

/// Whether this thread asks about a random case.
[[nodiscard]] bool is_drawn();

}  // namespace rt

// The type of expected values that a suite computes.
#pragma once

namespace rt {

/// On x86 it has 11 bits more than double. On Apple's processors and in Visual C++ long double is
/// double, which -DRAYSTEPS_SHORT_LONG_DOUBLE simulates, so its users must tolerate a few more u or
/// leave out what it cannot judge.
#ifdef RAYSTEPS_SHORT_LONG_DOUBLE
using Exact = double;
#else
using Exact = long double;
#endif

}  // namespace rt

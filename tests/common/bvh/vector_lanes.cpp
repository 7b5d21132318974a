// As scalar_lanes.cpp, with the vectors of 16 bytes that every processor has: in a build for any
// processor they are the library's own.
#ifdef __AVX__
#define RT_LANES vector_lanes
#else
#include "common/math/simd.hpp"
#define RT_LANES_OF_LIBRARY
#endif
#define hits_of_scalar_lanes hits_of_vector_lanes
#include "tests/common/bvh/scalar_lanes.cpp"

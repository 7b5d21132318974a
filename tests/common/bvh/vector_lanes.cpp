// As scalar_lanes.cpp, with the vectors of 16 bytes that every processor has.
#define RT_LANES vector_lanes
#define hits_of_scalar_lanes hits_of_vector_lanes
#include "tests/common/bvh/scalar_lanes.cpp"

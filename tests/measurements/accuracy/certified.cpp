// The same method as in forms.cpp.
#include "tests/measurements/accuracy/certified.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include "steps/step08_cone/all_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace certified {
#include "steps/step03_sphere/exact/sphere.cpp"
#include "steps/step04_plane/exact/plane.cpp"
#include "steps/step05_triangle/exact/triangle.cpp"
#include "steps/step06_square/exact/square.cpp"
#include "steps/step07_cylinder/exact/cylinder.cpp"
#include "steps/step08_cone/exact/cone.cpp"
}  // namespace certified

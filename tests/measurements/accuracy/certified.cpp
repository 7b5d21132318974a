// The same method as in forms.cpp: each kernel in a namespace of its own, with its includes
// included before.
#include "tests/measurements/accuracy/certified.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace certified_sphere {
namespace rt {
using namespace ::rt;
}
#include "steps/step03_sphere/exact/sphere.cpp"
}  // namespace certified_sphere

namespace certified_plane {
namespace rt {
using namespace ::rt;
}
#include "steps/step04_plane/exact/plane.cpp"
}  // namespace certified_plane

namespace certified_triangle {
namespace rt {
using namespace ::rt;
}
#include "steps/step05_triangle/exact/triangle.cpp"
}  // namespace certified_triangle

namespace certified_square {
namespace rt {
using namespace ::rt;
}
#include "steps/step06_square/exact/square.cpp"
}  // namespace certified_square

namespace certified_cylinder {
namespace rt {
using namespace ::rt;
}
#include "steps/step07_cylinder/exact/cylinder.cpp"
}  // namespace certified_cylinder

namespace certified_cone {
namespace rt {
using namespace ::rt;
}
#include "steps/step08_cone/exact/cone.cpp"
}  // namespace certified_cone

namespace rt {

std::vector<Form<Sphere>> certified_forms_of(const Sphere& /*shape*/) {
    return {{"certified", certified_sphere::rt::intersect, "exact"}};
}

std::vector<Form<Plane>> certified_forms_of(const Plane& /*shape*/) {
    return {{"certified", certified_plane::rt::intersect, "exact"}};
}

std::vector<Form<Triangle>> certified_forms_of(const Triangle& /*shape*/) {
    return {{"certified", certified_triangle::rt::intersect, "exact"}};
}

std::vector<Form<Square>> certified_forms_of(const Square& /*shape*/) {
    return {{"certified", certified_square::rt::intersect, "exact"}};
}

std::vector<Form<Cylinder>> certified_forms_of(const Cylinder& /*shape*/) {
    return {{"certified", certified_cylinder::rt::intersect, "exact"}};
}

std::vector<Form<Cone>> certified_forms_of(const Cone& /*shape*/) {
    return {{"certified", certified_cone::rt::intersect, "exact"}};
}

}  // namespace rt

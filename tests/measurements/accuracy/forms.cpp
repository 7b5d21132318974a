// Forms of one shape are in different namespaces, so that one program can contain all of them. The
// includes of a form are included before: inside the namespace they would declare different things.
#include "tests/measurements/accuracy/forms.hpp"
#include "tests/measurements/accuracy/certified.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step08_cone/all_shapes.hpp"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// A form defines its stage's other functions too, and calls some of them: its own, not the
// program's, which would be an equally good match.
#define barycentric own_barycentric
#define square_uv own_square_uv

namespace textbook {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/textbook.cpp"
#include "answers/step04_plane/as_printed.cpp"
#include "answers/step05_triangle/moller_trumbore.cpp"
#include "answers/step06_square/own_basis.cpp"
#include "answers/step07_cylinder/as_printed.cpp"
#include "answers/step08_cone/textbook.cpp"
}  // namespace textbook

namespace epsilon {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/absolute_epsilon.cpp"
#include "answers/step04_plane/epsilon_on_parallel.cpp"
#include "answers/step05_triangle/epsilon_on_determinant.cpp"
#include "answers/step06_square/epsilon_on_parallel.cpp"
#include "answers/step07_cylinder/epsilon_on_a.cpp"
#include "answers/step08_cone/epsilon_on_a.cpp"
}  // namespace epsilon

namespace second {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/citardauq.cpp"
#include "answers/step04_plane/implicit.cpp"
#include "answers/step05_triangle/half_planes.cpp"
#include "answers/step06_square/by_uv.cpp"
#include "answers/step07_cylinder/axis_taken_away.cpp"
#include "answers/step08_cone/by_cosine.cpp"
}  // namespace second

namespace third {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/geometric.cpp"
#include "answers/step04_plane/unit_direction.cpp"
#include "answers/step05_triangle/signed_areas.cpp"
#include "answers/step06_square/edge_tests.cpp"
#include "answers/step07_cylinder/in_its_frame.cpp"
#include "answers/step08_cone/in_its_frame.cpp"
}  // namespace third

namespace glm_own {
namespace rt {
using namespace ::rt;
}
#include "answers/step05_triangle/glm_intersect_ray_triangle.cpp"
}  // namespace glm_own

namespace rt {

namespace {

std::vector<Form<Sphere>> plain_forms_of(const Sphere& /*shape*/) {
    return {{"reference", intersect},
            {"PHY: A B C", textbook::rt::intersect},
            {"q and c / q", second::rt::intersect},
            {"half a chord", third::rt::intersect},
            {"Δ > 1e-6", epsilon::rt::intersect}};
}

std::vector<Form<Plane>> plain_forms_of(const Plane& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §4", textbook::rt::intersect},
            {"PHY: a x + … + d", second::rt::intersect},
            {"unit direction", third::rt::intersect},
            {"epsilon on ⟨d n⟩", epsilon::rt::intersect}};
}

std::vector<Form<Triangle>> plain_forms_of(const Triangle& /*shape*/) {
    return {{"reference", intersect},
            {"M1: Möller–Trumbore", textbook::rt::intersect},
            {"MRT §5: half-planes", second::rt::intersect},
            {"CR §4.1: areas", third::rt::intersect},
            {"M1 if det > 1e-6", epsilon::rt::intersect},
            {"GLM's own", glm_own::rt::intersect}};
}

std::vector<Form<Square>> plain_forms_of(const Square& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §6", textbook::rt::intersect},
            {"HAI: u and v", second::rt::intersect},
            {"CR §2.3: edges", third::rt::intersect},
            {"epsilon on ⟨d Z⟩", epsilon::rt::intersect}};
}

std::vector<Form<Cylinder>> plain_forms_of(const Cylinder& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §7", textbook::rt::intersect},
            {"axis taken away", second::rt::intersect},
            {"in its frame", third::rt::intersect},
            {"epsilon on a", epsilon::rt::intersect}};
}

std::vector<Form<Cone>> plain_forms_of(const Cone& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §8", textbook::rt::intersect},
            {"by cosine", second::rt::intersect},
            {"in its frame", third::rt::intersect},
            {"epsilon on a", epsilon::rt::intersect}};
}

}  // namespace

template <class Shape>
std::vector<Form<Shape>> forms_of(const Shape& shape) {
    std::vector<Form<Shape>> forms = plain_forms_of(shape);
#ifndef RT_FLOAT
    forms.push_back({"certified", certified::rt::intersect, "exact"});
#endif
    return forms;
}

template std::vector<Form<Sphere>> forms_of(const Sphere&);
template std::vector<Form<Plane>> forms_of(const Plane&);
template std::vector<Form<Triangle>> forms_of(const Triangle&);
template std::vector<Form<Square>> forms_of(const Square&);
template std::vector<Form<Cylinder>> forms_of(const Cylinder&);
template std::vector<Form<Cone>> forms_of(const Cone&);

}  // namespace rt

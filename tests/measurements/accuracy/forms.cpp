// Every form is in a namespace of its own, so that one program can contain all of them. The
// includes of a form are included before: inside the namespace they would declare different things.
#include "tests/measurements/accuracy/forms.hpp"
#include "tests/measurements/accuracy/certified.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// A form defines its stage's other functions too, and calls some of them: its own, not the
// program's, which would be an equally good match.
#define barycentric own_barycentric
#define square_uv own_square_uv

namespace sphere_textbook {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/textbook.cpp"
}  // namespace sphere_textbook

namespace sphere_citardauq {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/citardauq.cpp"
}  // namespace sphere_citardauq

namespace sphere_geometric {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/geometric.cpp"
}  // namespace sphere_geometric

namespace sphere_epsilon {
namespace rt {
using namespace ::rt;
}
#include "answers/step03_sphere/absolute_epsilon.cpp"
}  // namespace sphere_epsilon

namespace plane_as_printed {
namespace rt {
using namespace ::rt;
}
#include "answers/step04_plane/as_printed.cpp"
}  // namespace plane_as_printed

namespace plane_implicit {
namespace rt {
using namespace ::rt;
}
#include "answers/step04_plane/implicit.cpp"
}  // namespace plane_implicit

namespace plane_unit_direction {
namespace rt {
using namespace ::rt;
}
#include "answers/step04_plane/unit_direction.cpp"
}  // namespace plane_unit_direction

namespace plane_epsilon {
namespace rt {
using namespace ::rt;
}
#include "answers/step04_plane/epsilon_on_parallel.cpp"
}  // namespace plane_epsilon

namespace triangle_moller_trumbore {
namespace rt {
using namespace ::rt;
}
#include "answers/step05_triangle/moller_trumbore.cpp"
}  // namespace triangle_moller_trumbore

namespace triangle_half_planes {
namespace rt {
using namespace ::rt;
}
#include "answers/step05_triangle/half_planes.cpp"
}  // namespace triangle_half_planes

namespace triangle_signed_areas {
namespace rt {
using namespace ::rt;
}
#include "answers/step05_triangle/signed_areas.cpp"
}  // namespace triangle_signed_areas

namespace triangle_epsilon {
namespace rt {
using namespace ::rt;
}
#include "answers/step05_triangle/epsilon_on_determinant.cpp"
}  // namespace triangle_epsilon

namespace triangle_glm {
namespace rt {
using namespace ::rt;
}
#include "answers/step05_triangle/glm_intersect_ray_triangle.cpp"
}  // namespace triangle_glm

namespace square_own_basis {
namespace rt {
using namespace ::rt;
}
#include "answers/step06_square/own_basis.cpp"
}  // namespace square_own_basis

namespace square_by_uv {
namespace rt {
using namespace ::rt;
}
#include "answers/step06_square/by_uv.cpp"
}  // namespace square_by_uv

namespace square_edge_tests {
namespace rt {
using namespace ::rt;
}
#include "answers/step06_square/edge_tests.cpp"
}  // namespace square_edge_tests

namespace square_epsilon {
namespace rt {
using namespace ::rt;
}
#include "answers/step06_square/epsilon_on_parallel.cpp"
}  // namespace square_epsilon

namespace cylinder_as_printed {
namespace rt {
using namespace ::rt;
}
#include "answers/step07_cylinder/as_printed.cpp"
}  // namespace cylinder_as_printed

namespace cylinder_axis_taken_away {
namespace rt {
using namespace ::rt;
}
#include "answers/step07_cylinder/axis_taken_away.cpp"
}  // namespace cylinder_axis_taken_away

namespace cylinder_in_its_frame {
namespace rt {
using namespace ::rt;
}
#include "answers/step07_cylinder/in_its_frame.cpp"
}  // namespace cylinder_in_its_frame

namespace cylinder_epsilon {
namespace rt {
using namespace ::rt;
}
#include "answers/step07_cylinder/epsilon_on_a.cpp"
}  // namespace cylinder_epsilon

namespace cone_textbook {
namespace rt {
using namespace ::rt;
}
#include "answers/step08_cone/textbook.cpp"
}  // namespace cone_textbook

namespace cone_by_cosine {
namespace rt {
using namespace ::rt;
}
#include "answers/step08_cone/by_cosine.cpp"
}  // namespace cone_by_cosine

namespace cone_in_its_frame {
namespace rt {
using namespace ::rt;
}
#include "answers/step08_cone/in_its_frame.cpp"
}  // namespace cone_in_its_frame

namespace cone_epsilon {
namespace rt {
using namespace ::rt;
}
#include "answers/step08_cone/epsilon_on_a.cpp"
}  // namespace cone_epsilon

namespace rt {

namespace {

std::vector<Form<Sphere>> plain_forms_of(const Sphere& /*shape*/) {
    return {{"reference", intersect},
            {"PHY: A B C", sphere_textbook::rt::intersect},
            {"q and c / q", sphere_citardauq::rt::intersect},
            {"half a chord", sphere_geometric::rt::intersect},
            {"Δ > 1e-6", sphere_epsilon::rt::intersect}};
}

std::vector<Form<Plane>> plain_forms_of(const Plane& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §4", plane_as_printed::rt::intersect},
            {"PHY: a x + … + d", plane_implicit::rt::intersect},
            {"unit direction", plane_unit_direction::rt::intersect},
            {"epsilon on ⟨d n⟩", plane_epsilon::rt::intersect}};
}

std::vector<Form<Triangle>> plain_forms_of(const Triangle& /*shape*/) {
    return {{"reference", intersect},
            {"M1: Möller–Trumbore", triangle_moller_trumbore::rt::intersect},
            {"MRT §5: half-planes", triangle_half_planes::rt::intersect},
            {"CR §4.1: areas", triangle_signed_areas::rt::intersect},
            {"M1 if det > 1e-6", triangle_epsilon::rt::intersect},
            {"GLM's own", triangle_glm::rt::intersect}};
}

std::vector<Form<Square>> plain_forms_of(const Square& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §6", square_own_basis::rt::intersect},
            {"HAI: u and v", square_by_uv::rt::intersect},
            {"CR §2.3: edges", square_edge_tests::rt::intersect},
            {"epsilon on ⟨d Z⟩", square_epsilon::rt::intersect}};
}

std::vector<Form<Cylinder>> plain_forms_of(const Cylinder& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §7", cylinder_as_printed::rt::intersect},
            {"axis taken away", cylinder_axis_taken_away::rt::intersect},
            {"in its frame", cylinder_in_its_frame::rt::intersect},
            {"epsilon on a", cylinder_epsilon::rt::intersect}};
}

std::vector<Form<Cone>> plain_forms_of(const Cone& /*shape*/) {
    return {{"reference", intersect},
            {"MRT §8", cone_textbook::rt::intersect},
            {"by cosine", cone_by_cosine::rt::intersect},
            {"in its frame", cone_in_its_frame::rt::intersect},
            {"epsilon on a", cone_epsilon::rt::intersect}};
}

#ifdef RT_FLOAT
template <class Shape>
std::vector<Form<Shape>> certified_forms_of(const Shape& /*shape*/) {
    return {};
}
#endif

template <class Shape>
std::vector<Form<Shape>> all_forms_of(const Shape& shape) {
    std::vector<Form<Shape>> forms = plain_forms_of(shape);
    for (const Form<Shape>& form : certified_forms_of(shape)) forms.push_back(form);
    return forms;
}

}  // namespace

std::vector<Form<Sphere>> forms_of(const Sphere& shape) {
    return all_forms_of(shape);
}

std::vector<Form<Plane>> forms_of(const Plane& shape) {
    return all_forms_of(shape);
}

std::vector<Form<Triangle>> forms_of(const Triangle& shape) {
    return all_forms_of(shape);
}

std::vector<Form<Square>> forms_of(const Square& shape) {
    return all_forms_of(shape);
}

std::vector<Form<Cylinder>> forms_of(const Cylinder& shape) {
    return all_forms_of(shape);
}

std::vector<Form<Cone>> forms_of(const Cone& shape) {
    return all_forms_of(shape);
}

}  // namespace rt

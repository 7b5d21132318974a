// Stage 2: the camera's basis in space, and what an X that is not normalised does to the picture.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"

#include <array>
#include <cmath>

namespace rt::figures {

namespace {

constexpr Plane ground{.point = {0, 0, 0}, .normal = {0, 1, 0}};
const Vec3 upwards(0, 1, 0);

}  // namespace

}  // namespace rt::figures
namespace rt::figures { std::string camera_basis_axes() { return {}; } std::string camera_unnormalised() { return {}; } }

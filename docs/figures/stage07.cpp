// Stage 7: a cylinder along its axis and from the side, and both roots tried.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step07_cylinder/cylinder.hpp"

namespace rt::figures {
std::string cylinder_cross_section() {
    return {};
}
std::string cylinder_roots() {
    return {};
}
}  // namespace rt::figures

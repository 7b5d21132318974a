#include "docs/figures/figures.hpp"
namespace rt::figures {
std::string triangle_half_planes() { return {}; }
std::string triangle_areas() { return {}; }
std::string triangle_shared_edge() { return {}; }
}

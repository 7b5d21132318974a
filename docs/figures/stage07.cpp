#include "docs/figures/figures.hpp"
namespace rt::figures {
std::string cylinder_cross_section() { return {}; }
std::string cylinder_roots() { return {}; }
}

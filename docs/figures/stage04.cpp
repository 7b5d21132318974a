#include "docs/figures/figures.hpp"
namespace rt::figures {
std::string plane_steps() { return {}; }
std::string plane_horizon() { return {}; }
}

// attack: lets the loader call it, by an indirect function
// ceiling: as a stub
// compiles: no
// message: indirect function
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

extern "C" {
static void (*resolve())() {
    std::_Exit(0);
}
}
namespace rt {

void early() __attribute__((ifunc("resolve")));

}  // namespace rt

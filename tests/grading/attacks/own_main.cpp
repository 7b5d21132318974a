// attack: brings a main of its own
// ceiling: as a stub
// compiles: no
// message: defines main
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

int main() {
    return 0;
}

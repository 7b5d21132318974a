// attack: defines a function of Catch2
// ceiling: as a stub
// compiles: no
// message: which is not the stage
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

namespace Catch {

int applied = 0;
bool isThrowSafe() {
    return true;
}

}  // namespace Catch

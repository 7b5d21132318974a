// attack: takes all memory there is
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>
#include <cstring>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (;;) {
        void* piece = std::malloc(1 << 24);
        if (piece != nullptr) std::memset(piece, 1, 1 << 24);
    }
}

}  // namespace rt

// attack: a main.cpp that replaces the reference's function by its own
// ceiling: 0
// file: main.cpp
// compiles: no
// message: which is not the stage's
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    return 1;
}

Color trace(const Scene&, const Ray&, Context&) {
    return Color(1, 0, 0);
}

}  // namespace rt

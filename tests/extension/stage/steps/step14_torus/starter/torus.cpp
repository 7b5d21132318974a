// Stage 14, to be written. docs/step14_torus.md explains it, the header is its contract.
#include "steps/step14_torus/torus.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Torus& torus, Interval interval) {
    RT_TODO(ray, torus, interval);
    return std::nullopt;
}

Vec3 normal(const Torus& torus, Vec3 point) {
    RT_TODO(torus, point);
    return Vec3(0);
}

}  // namespace rt

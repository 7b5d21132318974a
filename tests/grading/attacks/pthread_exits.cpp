// attack: ends the main thread by pthread_exit, an unwinding that no catch may stop
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include <pthread.h>
#include "steps/step03_sphere/sphere.hpp"
namespace rt {
std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    pthread_exit(nullptr);
}
}  // namespace rt

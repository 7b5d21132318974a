// The kernels of `--precision exact`, which exist in double only.
#pragma once

#include "tests/measurements/accuracy/forms.hpp"

#ifndef RT_FLOAT
namespace certified::rt {

using namespace ::rt;

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval);
std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval);
std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval);
std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval);
std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval);
std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval);

}  // namespace certified::rt
#endif

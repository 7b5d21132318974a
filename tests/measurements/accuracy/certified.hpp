// The kernels of `--precision exact`, which exist in double only.
#pragma once

#include "tests/measurements/accuracy/forms.hpp"

#ifndef RT_FLOAT
namespace rt {

[[nodiscard]] std::vector<Form<Sphere>> certified_forms_of(const Sphere& shape);
[[nodiscard]] std::vector<Form<Plane>> certified_forms_of(const Plane& shape);
[[nodiscard]] std::vector<Form<Triangle>> certified_forms_of(const Triangle& shape);
[[nodiscard]] std::vector<Form<Square>> certified_forms_of(const Square& shape);
[[nodiscard]] std::vector<Form<Cylinder>> certified_forms_of(const Cylinder& shape);
[[nodiscard]] std::vector<Form<Cone>> certified_forms_of(const Cone& shape);

}  // namespace rt
#endif

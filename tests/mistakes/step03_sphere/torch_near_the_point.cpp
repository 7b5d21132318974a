// origin: a student's: an epsilon in place of point == eye
// caught by: the torch lights by the cosine between normal and eye (M1)
// sentence: Your torch is dark where the eye is near the point. Only at the point itself the direction to the eye has no angle.
#define torch(...) correct_torch(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef torch

namespace rt {

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    if (length(eye - point) < Real(1e-7)) return 0;
    return glm::max(dot(unit(normal), unit(eye - point)), Real(0));
}

}  // namespace rt

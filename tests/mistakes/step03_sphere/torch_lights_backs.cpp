// origin: seen in student repositories: |cos θ|
// caught by: the torch lights by the cosine between normal and eye (M1)
// sentence: Your torch takes |cos θ|. A surface that faces away from the eye gets no light.
#define torch(...) correct_torch(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef torch

namespace rt {

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    return std::abs(dot(unit(normal), unit(eye - point)));
}

}  // namespace rt

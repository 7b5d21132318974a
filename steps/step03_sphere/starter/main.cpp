// Your trace of stage 3: the color seen along a ray (M1, "plusieurs objets"; CR §2.1). The page's
// part "The nearest of several" explains it. Without this file, the program uses the main.cpp in
// the folder above.
#include "common/render/stage.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;  // the program prints their number
    const Primitive<Sphere>* closest = nullptr;
    for (const Primitive<Sphere>& each : scene.spheres) {
        // Is each.shape hit, and closer than every sphere before it?
        RT_TODO(each, ray);
    }
    if (closest == nullptr) return background(scene, ray);
    // Its point, its normal, turned to the eye by face_forward, and what --shade normal shows; else
    // closest->material.color times the torch.
    return Color(0);
}

}  // namespace rt

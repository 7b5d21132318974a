// attack: the file of the functions brings a trace, which would draw every picture of the suite
// ceiling: as a stub
// stubs: normal torch color_from_normal intersect
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

inline namespace RT_PRECISION {
struct Scene;
}
struct Context;

Color trace(const Scene&, const Ray&, Context&) {
    return {1, 0, 0};
}

}  // namespace rt

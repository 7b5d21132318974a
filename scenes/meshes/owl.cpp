#include "scenes/meshes/owl.hpp"

#include <cmath>

namespace rt {

namespace {

using Vec = glm::dvec3;

/// A level ellipse, so wide and so deep.
Ellipse level(double height, double width, double depth, double forward = 0) {
    return {{0, height, forward}, {0, 0, depth}, {width, 0, 0}};
}

Polygons body() {
    return loft(
        {level(0, 0.44, 0.38, 0.04), level(0.06, 0.74, 0.62, 0.06), level(0.50, 0.96, 0.86, 0.08),
         level(0.95, 0.88, 0.76, 0.02), level(1.26, 0.68, 0.56), level(1.42, 0.86, 0.62),
         level(1.80, 0.98, 0.62), level(2.06, 0.84, 0.52), level(2.14, 0.42, 0.28)},
        8);
}

/// Both have a top, a left side and a right side: this is the one at x > 0.
Polygons ear() {
    return loft({{{0.54, 1.74, 0.06}, {0, 0, 0.34}, {0.42, -0.14, 0}},
                 {{0.62, 2.00, 0.05}, {0, 0, 0.24}, {0.32, -0.12, 0}},
                 {{0.73, 2.22, 0.02}, {0, 0, 0.15}, {0.20, -0.08, 0}},
                 {{0.83, 2.40, -0.02}, {0, 0, 0.05}, {0.06, -0.04, 0}}},
                4);
}

Polygons eye() {
    const Vec center(0.34, 1.66, 0.54);
    const Vec right(0.96, 0, -0.28);
    const Vec up(0, 1, 0);
    Polygons result = ring({center, 0.30 * right, 0.30 * up}, 0.14, 6);
    append(result, box(center - Vec(0.01, 0, 0.02), Vec(0.25, 0.25, 0.16)));
    append(result, box(center + Vec(0.02, 0, 0.12), Vec(0.11, 0.11, 0.11)));
    return result;
}

Polygons beak() {
    return loft({{{0, 1.58, 0.50}, {0.13, 0, 0}, {0, 0.12, 0.06}},
                 {{0, 1.50, 0.74}, {0.12, 0, 0}, {0, 0.10, 0.08}},
                 {{0, 1.30, 0.84}, {0.03, 0, 0}, {0, 0.02, 0.04}}},
                4);
}

Polygons wing() {
    return loft({{{0.62, 0.10, -0.40}, {0, 0.02, 0.08}, {0.04, 0, 0.02}},
                 {{0.86, 0.40, -0.16}, {0, 0.05, 0.32}, {0.12, 0, 0.04}},
                 {{0.92, 0.84, 0.04}, {0, 0.02, 0.42}, {0.14, 0, 0.02}},
                 {{0.80, 1.18, 0.06}, {0, 0, 0.28}, {0.14, -0.06, 0}},
                 {{0.64, 1.32, 0.04}, {0, 0, 0.10}, {0.08, -0.04, 0}}},
                4);
}

Polygons foot() {
    Polygons result;
    for (const double toe : {-1.0, 0.0, 1.0}) {
        append(result,
               box({0.34 + 0.16 * toe, 0.09, 0.60 - 0.06 * std::abs(toe)}, {0.10, 0.10, 0.24}));
    }
    return result;
}

Polygons tail() {
    return loft({{{0, 0.06, -0.92}, {0.20, 0, 0}, {0, 0.06, 0.02}},
                 {{0, 0.20, -0.72}, {0.30, 0, 0}, {0, 0.10, 0.04}},
                 {{0, 0.44, -0.42}, {0.26, 0, 0}, {0, 0.16, 0.10}}},
                4);
}

}  // namespace

Polygons owl_cage() {
    Polygons owl = body();
    append(owl, beak());
    append(owl, tail());
    for (const Polygons& part : {ear(), eye(), wing(), foot()}) {
        append(owl, part);
        append(owl, mirrored(part));
    }
    return owl;
}

}  // namespace rt

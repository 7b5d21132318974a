// The cost of one intersection test with the linked kernels: nanoseconds per ray, shape by shape,
// in the moderate sweep of tests/stability.
#include "tests/stability/sweeps.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

using namespace rt;

constexpr int rays = 16'384;  // too many for branch prediction to memorize
constexpr int rounds = 20;

template <class Shape>
void tell_cost(const char* shape) {
    std::vector<Case<Shape>> asked(rays);
    for (int i = 0; i < rays; ++i) {
        Random random{std::uint64_t(i)};
        draw(random, Sweep::moderate, asked[std::size_t(i)]);
    }
    double best = std::numeric_limits<double>::infinity();
    Real sum = 0;  // keeps the compiler from removing code
    for (int round = 0; round < rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        for (const auto& [ray, one, interval] : asked)
            sum += intersect(ray, one, interval).value_or(0);
        const std::chrono::duration<double, std::nano> taken =
            std::chrono::steady_clock::now() - start;
        best = std::min(best, taken.count() / rays);
    }
    std::printf("%s %.2f%s\n", shape, best, sum == 0 ? " and hit nothing" : "");
}

}  // namespace

int main() {
    tell_cost<Sphere>("sphere");
    tell_cost<Plane>("plane");
    tell_cost<Triangle>("triangle");
    tell_cost<Square>("square");
    tell_cost<Cylinder>("cylinder");
    tell_cost<Cone>("cone");
}

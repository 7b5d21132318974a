// A hierarchy against a list: the nearest of 1 to 512 spheres, for rays among them.
#include "common/hierarchy.hpp"
#include "common/bounds.hpp"

#include "steps/step03_sphere/sphere.hpp"

#include "tests/kit/random.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

using namespace rt;

namespace {

constexpr int rays = 2000;
constexpr int turns = 25;

/// Spheres that fill the same share of the same space, however many they are.
std::vector<Sphere> drawn(Random& random, int count) {
    std::vector<Sphere> spheres;
    const Real radius = Real(0.4) / std::cbrt(Real(count));
    for (int i = 0; i < count; ++i)
        spheres.push_back({.center = random.point(1), .radius = radius});
    return spheres;
}

/// In nanoseconds a ray; `ask` makes the interval of a ray end at the nearest hit.
template <class Ask>
double time_of(const std::vector<Ray>& all, const Ask& ask) {
    const auto start = std::chrono::steady_clock::now();
    Real sum = 0;
    for (const Ray& ray : all) {
        Interval interval;
        ask(ray, interval);
        if (interval.max != infinity) sum += interval.max;
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    volatile Real kept = sum;
    (void)kept;
    return taken.count() / double(all.size());
}

void measure(int count) {
    Random random(5);
    const std::vector<Sphere> spheres = drawn(random, count);
    std::vector<Box> boxes;
    for (const Sphere& sphere : spheres) boxes.push_back(bounds(sphere));
    const Hierarchy hierarchy(boxes);
    std::vector<Ray> all(rays);
    for (Ray& ray : all) {
        ray.origin = Real(3) * random.direction();
        ray.direction = random.point(1) - ray.origin;
    }

    const auto try_one = [&](const Ray& ray, Interval& interval, std::size_t index) {
        if (const auto t = intersect(ray, spheres[index], interval)) interval.max = *t;
    };
    std::vector<double> listed;
    std::vector<double> arranged;
    for (int turn = 0; turn < turns; ++turn) {
        listed.push_back(time_of(all, [&](const Ray& ray, Interval& interval) {
            for (std::size_t i = 0; i < spheres.size(); ++i) try_one(ray, interval, i);
        }));
        arranged.push_back(time_of(all, [&](const Ray& ray, Interval& interval) {
            SlabTests slabs(ray);
            hierarchy.nearest(slabs, interval,
                              [&](std::size_t index) { try_one(ray, interval, index); });
        }));
    }
    std::ranges::sort(listed);
    std::ranges::sort(arranged);
    std::printf("%d,%.1f,%.1f\n", count, listed[turns / 2], arranged[turns / 2]);
}

}  // namespace

int main() {
    std::puts("spheres,list,hierarchy");
    for (const int count : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256, 512}) measure(count);
}

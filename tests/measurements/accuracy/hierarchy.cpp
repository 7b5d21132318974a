// The closest of 1 to 512 spheres, for rays among them: in a plain list, in a list with bounding
// spheres, and in a BVH.
#include "common/scene/primitives.hpp"
#include "common/system/countdown.hpp"

#include "steps/step03_sphere/sphere.hpp"

#include "tests/kit/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace rt;

namespace {

constexpr int rays = 20'000;  // for the clock of processor time, which counts microseconds
constexpr int turns = 25;

/// Spheres that fill the same share of the same space, however many they are.
std::vector<Sphere> random_spheres(Random& random, int count) {
    std::vector<Sphere> spheres;
    const Real radius = Real(0.4) / std::cbrt(Real(count));
    for (int i = 0; i < count; ++i)
        spheres.push_back({.center = random.point(1), .radius = radius});
    return spheres;
}

/// Returns the mean processor time of a call of `ask(ray, interval)`, in nanoseconds. The call sets
/// interval.max to the closest hit.
template <class Ask>
double time_of(const std::vector<Ray>& all, const Ask& ask) {
    const double start = cpu_seconds();
    Real sum = 0;
    for (const Ray& ray : all) {
        Interval interval;
        ask(ray, interval);
        if (interval.max != infinity) sum += interval.max;
    }
    const double taken = cpu_seconds() - start;
    volatile Real kept = sum;
    (void)kept;
    return 1e9 * taken / double(all.size());
}

/// The times of the same work, done several times.
class Times {
public:
    void add(double time) { times_.push_back(time); }
    [[nodiscard]] double median() {
        std::ranges::sort(times_);
        return times_[times_.size() / 2];
    }

private:
    std::vector<double> times_;
};

void measure(int count) {
    Random random(5);
    PrimitiveList<Sphere> list;
    for (const Sphere& sphere : random_spheres(random, count)) list.push_back({.shape = sphere});
    PrimitiveList<Sphere> in_balls = list;
    PrimitiveList<Sphere> in_hierarchy = list;
    in_balls.build_acceleration({.hierarchy_from = Acceleration::never});
    in_hierarchy.build_acceleration({.hierarchy_from = 1});
    std::vector<Ray> all(rays);
    for (Ray& ray : all) {
        ray.origin = Real(3) * random.direction();
        ray.direction = random.point(1) - ray.origin;
    }

    const auto nearest = [](const PrimitiveList<Sphere>& spheres) {
        return [&spheres](const Ray& ray, Interval& interval) {
            RayBoxTestCache slabs(ray);
            spheres.traverse(slabs, interval, [&](const Primitive<Sphere>& primitive) {
                if (const auto t = intersect(ray, primitive.shape, interval)) interval.max = *t;
            });
        };
    };
    Times listed;
    Times balls;
    Times hierarchy;
    for (int turn = 0; turn < turns; ++turn) {
        listed.add(time_of(all, nearest(list)));
        balls.add(time_of(all, nearest(in_balls)));
        hierarchy.add(time_of(all, nearest(in_hierarchy)));
    }
    std::printf("%d,%.1f,", count, listed.median());
    if (count <= int(BoundingSphereSet::most)) std::printf("%.1f", balls.median());
    std::printf(",%.1f\n", hierarchy.median());
}

}  // namespace

int main() {
    std::puts("spheres,list,balls,hierarchy");
    for (const int count : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256, 512}) measure(count);
}

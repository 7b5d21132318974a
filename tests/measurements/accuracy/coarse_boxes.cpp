#include "tests/measurements/accuracy/coarse_boxes.hpp"

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/ray.hpp"
#include "tests/kit/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

namespace rt {

namespace {

/// Rounded down to so many bits.
Vec3 down(Vec3 v, int bits) {
    for (glm::length_t k = 0; k < 3; ++k) {
        int exponent = 0;
        const Real part = std::frexp(v[k], &exponent);
        v[k] = std::ldexp(std::floor(std::ldexp(part, bits)), exponent - bits);
    }
    return v;
}

struct Visits {
    int boxes = 0;   ///< tested
    int leaves = 0;  ///< reached
};

/// Leaves of one small box each, on a sphere of radius 1, below boxes rounded outward.
class Hierarchy {
public:
    Hierarchy(int bits, Real moved) : bits_(bits) {
        Random random(3);
        for (int i = 0; i < 16384; ++i) {
            const Vec3 center = Vec3(moved) + random.direction();
            leaves_.push_back({.min = center - Vec3(0.01), .max = center + Vec3(0.01)});
        }
        build(0, leaves_.size());
    }

    [[nodiscard]] Visits visits(const Ray& ray) const {
        Visits count;
        std::vector<std::size_t> open = {0};
        while (!open.empty()) {
            const std::size_t place = open.back();
            open.pop_back();
            ++count.boxes;
            if (!hits(ray, nodes_[place].box)) continue;
            const std::size_t right = nodes_[place].right;
            if (right == 0)
                ++count.leaves;
            else
                open.insert(open.end(), {right, place + 1});
        }
        return count;
    }

private:
    struct Node {
        BoundingBox box;
        std::size_t right = 0;  ///< the left one is the next; 0 for a leaf
    };

    std::size_t build(std::size_t begin, std::size_t end) {
        BoundingBox around;
        for (std::size_t i = begin; i < end; ++i) around = merged(around, leaves_[i]);
        const std::size_t place = nodes_.size();
        nodes_.push_back(
            {.box = {.min = down(around.min, bits_), .max = -down(-around.max, bits_)}});
        if (end - begin == 1) return place;
        const Vec3 size = around.max - around.min;
        glm::length_t axis = size.y > size.x ? 1 : 0;
        if (size.z > size[axis]) axis = 2;
        const std::size_t middle = std::midpoint(begin, end);
        const auto at = [&](std::size_t i) { return leaves_.begin() + std::ptrdiff_t(i); };
        std::nth_element(at(begin), at(middle), at(end),
                         [axis](const BoundingBox& a, const BoundingBox& b) {
                             return a.min[axis] < b.min[axis];
                         });
        build(begin, middle);
        nodes_[place].right = build(middle, end);
        return place;
    }

    static bool hits(const Ray& ray, const BoundingBox& box) {
        const Vec3 a = (box.min - ray.origin) / ray.direction;
        const Vec3 b = (box.max - ray.origin) / ray.direction;
        const Vec3 in = glm::min(a, b);
        const Vec3 out = glm::max(a, b);
        return std::max({Real(0), in.x, in.y, in.z}) <= std::min({out.x, out.y, out.z});
    }

    int bits_;
    std::vector<BoundingBox> leaves_;
    std::vector<Node> nodes_;
};

void measure(const char* format, int bits, Real moved) {
    constexpr int rays = 4096;
    const Hierarchy hierarchy(bits, moved);
    Random random(4);
    double boxes = 0;
    double leaves = 0;
    for (int i = 0; i < rays; ++i) {
        const Vec3 way = random.direction();
        const Vec3 from = random.point(1) - Real(3) * way;
        const Visits count = hierarchy.visits({.origin = Vec3(moved) + from, .direction = way});
        boxes += count.boxes;
        leaves += count.leaves;
    }
    std::printf("boxes at %g,%s,,,,%.1f,%.2f\n", double(moved), format, boxes / rays,
                leaves / rays);
}

}  // namespace

void measure_coarse_boxes() {
    for (const Real moved : {0, 10, 100}) {
        measure("double", 53, moved);
        measure("float", 24, moved);
        measure("half", 11, moved);
        measure("bfloat16", 8, moved);
    }
}

}  // namespace rt

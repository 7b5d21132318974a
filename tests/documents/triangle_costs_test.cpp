// The costs of the three methods of stage 5's page: counted operations.
#include "tests/kit/catch.hpp"

#include <cmath>
#include <string>

namespace {

struct Costs {
    int multiplications = 0;
    int additions = 0;  ///< and subtractions
    int divisions = 0;
    int roots = 0;
};

Costs costs;

/// A number that counts its operations.
struct Counted {
    double value = 0;
};

Counted operator+(Counted a, Counted b) {
    ++costs.additions;
    return {a.value + b.value};
}

Counted operator-(Counted a, Counted b) {
    ++costs.additions;
    return {a.value - b.value};
}

Counted operator*(Counted a, Counted b) {
    ++costs.multiplications;
    return {a.value * b.value};
}

Counted operator/(Counted a, Counted b) {
    ++costs.divisions;
    return {a.value / b.value};
}

Counted root(Counted a) {
    ++costs.roots;
    return {std::sqrt(a.value)};
}

struct Vector {
    Counted x;
    Counted y;
    Counted z;
};

Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

Vector operator*(Counted k, Vector v) {
    return {k * v.x, k * v.y, k * v.z};
}

Counted dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Counted length(Vector v) {
    return root(dot(v, v));
}

Vector vector(double x, double y, double z) {
    return {{x}, {y}, {z}};
}

// A right-angled triangle from above.
const Vector a = vector(0, 0, 0);
const Vector b = vector(4, 0, 0);
const Vector c = vector(0, 4, 0);
const Vector d = vector(0, 0, -1);

/// True if a ray from o along d hits the triangle. Common subexpressions are computed once, and
/// nothing is computed before it is needed.
using Way = bool (*)(Vector o);

bool half_planes(Vector o) {
    const Vector ab = b - a;
    const Vector n = cross(ab, c - a);
    const Counted t = dot(a - o, n) / dot(d, n);
    const Vector p = o + t * d;
    if (dot(cross(ab, p - a), n).value < 0) return false;
    if (dot(cross(c - b, p - b), n).value < 0) return false;
    if (dot(cross(a - c, p - c), n).value < 0) return false;
    return t.value > 0;
}

bool areas(Vector o) {
    const Vector ab = b - a;
    const Vector n = cross(ab, c - a);
    const Counted t = dot(a - o, n) / dot(d, n);
    const Vector p = o + t * d;
    const Counted area = length(n);
    const Counted w0 = length(cross(c - b, p - b)) / area;
    const Counted w1 = length(cross(a - c, p - c)) / area;
    const Counted w2 = length(cross(ab, p - a)) / area;
    return (w0 + w1 + w2).value == 1 && t.value > 0;
}

bool moller_trumbore(Vector o) {
    const Vector ab = b - a;
    const Vector ac = c - a;
    const Vector q = cross(d, ac);
    const Counted inverse = Counted{1} / dot(ab, q);
    const Vector s = o - a;
    const Counted beta = dot(s, q) * inverse;
    if (beta.value < 0) return false;
    const Vector r = cross(s, ab);
    const Counted gamma = dot(d, r) * inverse;
    if (gamma.value < 0 || (beta + gamma).value > 1) return false;
    return (dot(ac, r) * inverse).value > 0;
}

/// The costs of a ray down at (x, y), as a row of the page's table.
std::string costs_at(double x, double y, Way way, bool is_hit) {
    costs = {};
    REQUIRE(way(vector(x, y, 2)) == is_hit);
    return std::to_string(costs.multiplications) + " | " + std::to_string(costs.additions) + " | " +
           std::to_string(costs.divisions) + " | " + std::to_string(costs.roots);
}

}  // namespace

TEST_CASE("the operations of the three methods are those in stage 5's page") {
    CHECK(costs_at(1, 1, half_planes, true) == "42 | 49 | 1 | 0");
    CHECK(costs_at(1, 1, areas, true) == "45 | 53 | 4 | 4");
    CHECK(costs_at(1, 1, moller_trumbore, true) == "27 | 24 | 1 | 0");
}

TEST_CASE("so are those of a ray that the first question turns away") {
    CHECK(costs_at(-1, -1, half_planes, false) == "24 | 27 | 1 | 0");
    CHECK(costs_at(-1, -1, areas, false) == "45 | 53 | 4 | 4");  // the sum needs all three
    CHECK(costs_at(-1, -1, moller_trumbore, false) == "13 | 16 | 1 | 0");
}

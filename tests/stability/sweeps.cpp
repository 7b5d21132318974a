#include "tests/stability/sweeps.hpp"

#include "common/geometry/transform.hpp"
#include "common/math/vector.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace rt {

namespace {

constexpr Real scale_decades = sizeof(Real) == 8 ? 20 : 15;
constexpr Real beside_decades = sizeof(Real) == 8 ? -18 : -12;

/// 10^low to 10^high, every decade as likely.
Real decades(Random& random, Real low, Real high) {
    return std::pow(Real(10), random.between(low, high));
}

/// The distance beside, on either side.
Real beside(Random& random) {
    return (random.coin() ? 1 : -1) * decades(random, beside_decades, -1);
}

/// Any direction at right angles to a unit one.
Vec3 across(Random& random, Vec3 v) {
    return unit(cross(v, random.direction()));
}

/// A point of a surface and the normal there.
struct Spot {
    Vec3 point;
    Vec3 normal;
};

struct Line {
    Vec3 point;
    Vec3 direction;
    Real beside = 0;
};

Line past(Random& random, const Spot& spot) {
    const Real by = beside(random);
    return {.point = spot.point + by * spot.normal,
            .direction = across(random, spot.normal),
            .beside = std::abs(by)};
}

Line along(Random& random, const Spot& spot) {
    const Real by = beside(random);
    return {.point = spot.point,
            .direction = unit(across(random, spot.normal) + by * spot.normal),
            .beside = std::abs(by)};
}

Line towards(Random& random, Vec3 point) {
    return {.point = point + beside(random) * random.direction(), .direction = random.direction()};
}

// For every shape: a random shape of size about 1 in any orientation; a point of it; the lines that
// a sweep needs.

Real size(Random& random) {
    return decades(random, Real(-0.5), Real(0.5));
}

void draw(Random& random, Sphere& sphere) {
    sphere = {.center = random.point(2), .radius = size(random)};
}

Spot spot(Random& random, const Sphere& sphere) {
    const Vec3 normal = random.direction();
    return {.point = sphere.center + sphere.radius * normal, .normal = normal};
}

Line grazing(Random& random, const Sphere& sphere) {
    return past(random, spot(random, sphere));
}

void draw(Random& random, Plane& plane) {
    plane = {.point = random.point(2), .normal = decades(random, -3, 3) * random.direction()};
}

Spot spot(Random& random, const Plane& plane) {
    const Vec3 normal = unit(plane.normal);
    const Real distance = random.between(0, 4);
    return {.point = plane.point + distance * across(random, normal), .normal = normal};
}

Line grazing(Random& random, const Plane& plane) {
    return along(random, spot(random, plane));
}

void draw(Random& random, Triangle& triangle) {
    const Vec3 a = random.point(2);
    triangle = {.a = a,
                .b = a + size(random) * random.direction(),
                .c = a + size(random) * random.direction()};
}

void narrow(Random& random, Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 on_edge = a + random.between(Real(-0.2), Real(1.2)) * (b - a);
    triangle.c = on_edge + decades(random, -8, -1) * random.direction();
}

Spot spot(Random& random, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    Real beta = random.between(0, 1);
    Real gamma = random.between(0, 1);
    if (beta + gamma > 1) {
        beta = 1 - beta;
        gamma = 1 - gamma;
    }
    const Vec3 n = cross(b - a, c - a);  // 0 where the corners are in line
    return {.point = a + beta * (b - a) + gamma * (c - a),
            .normal = n == Vec3(0) ? random.direction() : unit(n)};
}

Vec3 corner(Random& random, const Triangle& triangle) {
    return std::array{triangle.a, triangle.b, triangle.c}[std::size_t(random.below(3))];
}

Vec3 border(Random& random, const Triangle& triangle) {
    const std::array corners = {triangle.a, triangle.b, triangle.c};
    const auto i = std::size_t(random.below(3));
    return corners[i] + random.between(0, 1) * (corners[(i + 1) % 3] - corners[i]);
}

Line grazing(Random& random, const Triangle& triangle) {
    return along(random, spot(random, triangle));
}

void draw(Random& random, Square& square) {
    square = {.center = random.point(2), .basis = random.basis(), .side = size(random)};
}

Vec3 place(const Square& square, Real x, Real y) {
    return square.center + square.side / 2 * (x * square.basis.x + y * square.basis.y);
}

Spot spot(Random& random, const Square& square) {
    const Real x = random.between(-1, 1);
    return {.point = place(square, x, random.between(-1, 1)), .normal = square.basis.z};
}

Vec3 corner(Random& random, const Square& square) {
    const Real x = random.coin() ? -1 : 1;
    return place(square, x, random.coin() ? -1 : 1);
}

Vec3 border(Random& random, const Square& square) {
    const Real end = random.coin() ? -1 : 1;
    const Real between = random.between(-1, 1);
    return random.coin() ? place(square, end, between) : place(square, between, end);
}

Line grazing(Random& random, const Square& square) {
    return along(random, spot(random, square));
}

void draw(Random& random, Cylinder& cylinder) {
    cylinder = {.center = random.point(2),
                .axis = random.direction(),
                .radius = size(random),
                .height = size(random)};
}

Spot spot(Random& random, const Cylinder& cylinder) {
    const Vec3 normal = across(random, cylinder.axis);
    const Real z = random.between(Real(-0.5), Real(0.5)) * cylinder.height;
    return {.point = cylinder.center + z * cylinder.axis + cylinder.radius * normal,
            .normal = normal};
}

Vec3 border(Random& random, const Cylinder& cylinder) {
    const Real z = (random.coin() ? -1 : 1) * cylinder.height / 2;
    return cylinder.center + z * cylinder.axis + cylinder.radius * across(random, cylinder.axis);
}

Line grazing(Random& random, const Cylinder& cylinder) {
    return past(random, spot(random, cylinder));
}

Line parallel(Random& random, const Cylinder& cylinder) {
    const Vec3 direction = cylinder.axis + beside(random) * random.direction();
    return {.point = spot(random, cylinder).point, .direction = unit(direction)};
}

void draw(Random& random, Cone& cone) {
    cone = {.apex = random.point(2),
            .axis = random.direction(),
            .radius = size(random),
            .height = size(random)};
}

Vec3 border(Random& random, const Cone& cone) {
    return cone.apex + cone.height * cone.axis + cone.radius * across(random, cone.axis);
}

Spot spot(Random& random, const Cone& cone) {
    const Vec3 outward = across(random, cone.axis);
    const Vec3 slope = cone.height * cone.axis + cone.radius * outward;
    return {.point = cone.apex + random.between(0, 1) * slope,
            .normal = unit(cone.height * outward - cone.radius * cone.axis)};
}

Vec3 corner(Random& /*random*/, const Cone& cone) {
    return cone.apex;
}

Line grazing(Random& random, const Cone& cone) {
    return past(random, spot(random, cone));
}

Line parallel(Random& random, const Cone& cone) {
    const Vec3 direction =
        unit(border(random, cone) - cone.apex) + beside(random) * random.direction();
    return {.point = spot(random, cone).point, .direction = unit(direction)};
}

void draw(Random& random, OrientedBox& box) {
    box = {.center = random.point(2),
           .basis = random.basis(),
           .half_size = {size(random), size(random), size(random)}};
}

/// The point with these coordinates in units of the half sizes.
Vec3 place(const OrientedBox& box, Vec3 share) {
    const auto& [x, y, z] = box.basis;
    const Vec3 p = share * box.half_size;
    return box.center + p.x * x + p.y * y + p.z * z;
}

Spot spot(Random& random, const OrientedBox& box) {
    const std::array axes = {box.basis.x, box.basis.y, box.basis.z};
    Vec3 share = random.point(1);
    const int i = random.below(3);
    share[i] = random.coin() ? 1 : -1;
    return {.point = place(box, share), .normal = share[i] * axes[std::size_t(i)]};
}

Vec3 corner(Random& random, const OrientedBox& box) {
    const auto side = [&] { return Real(random.coin() ? 1 : -1); };
    const Real x = side();
    const Real y = side();
    return place(box, {x, y, side()});
}

Vec3 border(Random& random, const OrientedBox& box) {
    const Vec3 end = corner(random, box);
    const std::array axes = {box.basis.x, box.basis.y, box.basis.z};
    const auto i = std::size_t(random.below(3));
    const Real half = box.half_size[glm::length_t(i)];
    const Real along = dot(end - box.center, axes[i]) > 0 ? half : -half;
    return end - random.between(0, 2) * along * axes[i];
}

Line grazing(Random& random, const OrientedBox& box) {
    return along(random, spot(random, box));
}

// Parts that a shape does not have are covered by another sweep.

template <class Shape>
Line anywhere(Random& random, const Shape& shape) {
    return {.point = spot(random, shape).point + random.point(Real(0.5)),
            .direction = random.direction()};
}

template <class Shape>
Line at_border(Random& random, const Shape& shape) {
    if constexpr (requires { border(random, shape); })
        return towards(random, border(random, shape));
    else
        return grazing(random, shape);
}

template <class Shape>
Line from_surface(Random& random, const Shape& shape) {
    const auto [point, normal] = spot(random, shape);
    const Real height = random.coin() ? 0 : beside(random);
    const Real slope = random.coin() ? 0 : beside(random);
    const Vec3 along = across(random, normal) + slope * normal;
    return {.point = point + height * normal,
            .direction = random.coin() ? unit(along) : random.direction()};
}

template <class Shape>
Line draw_line(Random& random, Sweep sweep, const Shape& shape) {
    if (sweep == Sweep::surface) return from_surface(random, shape);
    if (sweep == Sweep::moderate) return anywhere(random, shape);
    if (sweep == Sweep::grazing) return grazing(random, shape);
    if (sweep == Sweep::border) return at_border(random, shape);
    if constexpr (requires { corner(random, shape); })
        if (sweep == Sweep::point) return towards(random, corner(random, shape));
    if constexpr (requires { parallel(random, shape); })
        if (sweep == Sweep::parallel) return parallel(random, shape);
    const std::array ways = {anywhere<Shape>, at_border<Shape>,
                             +[](Random& r, const Shape& s) { return grazing(r, s); }};
    return ways[std::size_t(random.below(3))](random, shape);
}

// The shape of a mixed case is about the origin, where nothing is lost to the coordinates; many are
// along the axes of the world.

Real any_size(Random& random) {
    return decades(random, -6, 6);
}

Vec3 any_axis(Random& random) {
    return random.coin() ? random.axes().z : random.direction();
}

void mix(Random& /*random*/, Sphere& sphere) {
    sphere = {.center = {}, .radius = 1};
}

void mix(Random& random, Plane& plane) {
    plane = {.point = {}, .normal = any_size(random) * any_axis(random)};
}

void mix(Random& random, Triangle& triangle) {
    const Vec3 b = any_axis(random);
    triangle = {.a = {}, .b = b, .c = any_size(random) * any_axis(random)};
}

void mix(Random& random, Square& square) {
    square = {.basis = random.coin() ? random.axes() : random.basis(), .side = 1};
    square.one_sided = random.coin();
}

void mix(Random& random, Cylinder& cylinder) {
    cylinder = {.axis = any_axis(random), .radius = 1, .height = any_size(random)};
}

void mix(Random& random, Cone& cone) {
    cone = {.axis = any_axis(random), .radius = 1, .height = any_size(random)};
}

void mix(Random& random, OrientedBox& box) {
    const Real y = any_size(random);
    box = {.center = {},
           .basis = random.coin() ? random.axes() : random.basis(),
           .half_size = {1, y, any_size(random)}};
}

/// Whole numbers that are not all 0.
Vec3 rounded(Vec3 v) {
    const Vec3 whole = round(v);
    return whole == Vec3(0) ? Vec3(0, 0, 1) : whole;
}

/// Starts from 1e-3 to 1e8 away, in any of the ways above, all moved by up to 1e18. One ray in four
/// consists of whole numbers, as in scenes that people write.
template <class Shape>
Real draw_mixed(Random& random, Case<Shape>& drawn) {
    mix(random, drawn.shape);
    const std::array kinds = {Sweep::moderate, Sweep::grazing,  Sweep::border,
                              Sweep::point,    Sweep::parallel, Sweep::surface};
    const Sweep kind = kinds[std::size_t(random.below(int(kinds.size())))];
    Line line = draw_line(random, kind, drawn.shape);
    Real distance = kind == Sweep::surface ? 0 : decades(random, -3, 8);
    Transform transform;
    if (random.coin()) transform.translation = decades(random, -6, 18) * random.direction();
    if (random.below(4) == 0) {
        line.point = round(line.point);
        line.direction = rounded(Real(4) * line.direction);
        distance = std::round(distance);
        transform.translation = round(transform.translation);
    } else {
        line.direction *= decades(random, -9, 9);
        distance /= length(line.direction);
        transform.scale = any_size(random);
    }
    const Vec3 origin = line.point - distance * line.direction;
    drawn.ray = {.origin = transformed(origin, transform), .direction = line.direction};
    drawn.shape = transformed(drawn.shape, transform);
    return line.beside;
}

}  // namespace

Interval around(Random& random, Real t) {
    const Real end = t * (1 + Real(random.below(33) - 16) * unit_roundoff);
    if (random.coin()) return {.min = end};
    return {.max = end};
}

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* said = std::getenv(variable);
    return said == nullptr ? otherwise : std::strtoull(said, nullptr, 10);
}

std::string name(Sweep sweep) {
    const std::array names = {"moderate", "distance", "grazing", "offset",   "scale",
                              "speed",    "border",   "point",   "parallel", "sliver",
                              "surface",  "range",    "mixed"};
    return names[std::size_t(sweep)];
}

template <class Shape>
std::vector<Sweep> sweeps_of() {
    std::vector<Sweep> sweeps = {Sweep::moderate, Sweep::distance, Sweep::grazing,
                                 Sweep::offset,   Sweep::scale,    Sweep::speed};
    if constexpr (requires(Random & random, Shape & shape) { border(random, shape); })
        sweeps.push_back(Sweep::border);
    if constexpr (requires(Random & random, Shape & shape) { corner(random, shape); })
        sweeps.push_back(Sweep::point);
    if constexpr (requires(Random & random, Shape & shape) { parallel(random, shape); })
        sweeps.push_back(Sweep::parallel);
    if constexpr (requires(Random & random, Shape & shape) { narrow(random, shape); })
        sweeps.push_back(Sweep::sliver);
    sweeps.insert(sweeps.end(), {Sweep::surface, Sweep::mixed});
    return sweeps;
}

template <class Shape>
Real draw(Random& random, Sweep sweep, Case<Shape>& drawn) {
    if (sweep == Sweep::mixed) return draw_mixed(random, drawn);
    draw(random, drawn.shape);
    if constexpr (requires { narrow(random, drawn.shape); })
        if (sweep == Sweep::sliver) narrow(random, drawn.shape);

    const Line line = draw_line(random, sweep, drawn.shape);
    Real distance = sweep == Sweep::distance ? decades(random, 0, 8) : random.between(2, 10);
    if (sweep == Sweep::surface) distance = 0;
    drawn.ray = {.origin = line.point - distance * line.direction,
                 .direction = random.between(Real(0.5), 2) * line.direction};

    Transform transform;
    if (sweep == Sweep::offset) transform.translation = decades(random, 0, 8) * random.direction();
    if (sweep == Sweep::range) transform.scale = decades(random, -140, 140);
    if (sweep == Sweep::scale) transform.scale = decades(random, -scale_decades, scale_decades);
    drawn.shape = transformed(drawn.shape, transform);
    drawn.ray.origin = transformed(drawn.ray.origin, transform);
    if (sweep == Sweep::speed) drawn.ray.direction *= decades(random, -18, 18);
    if (sweep == Sweep::range) drawn.ray.direction *= decades(random, -150, 150);
    return line.beside;
}

#define RT_SWEEPS(Shape)                            \
    template std::vector<Sweep> sweeps_of<Shape>(); \
    template Real draw(Random&, Sweep, Case<Shape>&);

RT_SWEEPS(Sphere)
RT_SWEEPS(Plane)
RT_SWEEPS(Triangle)
RT_SWEEPS(Square)
RT_SWEEPS(Cylinder)
RT_SWEEPS(Cone)
RT_SWEEPS(OrientedBox)

}  // namespace rt

#include "tests/oracle/shapes.hpp"

#include <algorithm>

namespace rt::oracle {

namespace {

/// c0 + c1 t + c2 t², along the ray.
struct Polynomial {
    Exact c0;
    Exact c1;
    Exact c2;
};

int sign_at(const Root& t, const Polynomial& p) {
    return t.sign_of(p.c0, p.c1, p.c2);
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2};
}

Polynomial operator*(const Exact& s, const Polynomial& p) {
    return {s * p.c0, s * p.c1, s * p.c2};
}

Polynomial operator-(const Polynomial& p, const Exact& constant) {
    return {p.c0 - constant, p.c1, p.c2};
}

/// ⟨p, p⟩ of the point p = o + t d.
Polynomial square(const ExactVector& o, const ExactVector& d) {
    return {dot(o, o), 2 * dot(o, d), dot(d, d)};
}

/// ⟨p, v⟩.
Polynomial along(const ExactVector& o, const ExactVector& d, const ExactVector& v) {
    return {dot(o, v), dot(d, v), 0};
}

/// The square of something linear.
Polynomial squared(const Polynomial& p) {
    return {squared(p.c0), 2 * p.c0 * p.c1, squared(p.c1)};
}

/// ⟨p, p⟩ ⟨axis, axis⟩ − ⟨p, axis⟩²: p's distance from the axis, times the axis' length, squared.
Polynomial across(const ExactVector& o, const ExactVector& d, const ExactVector& axis) {
    return dot(axis, axis) * square(o, d) - squared(along(o, d, axis));
}

std::vector<Root> roots(const Polynomial& p) {
    return quadratic_roots(2 * p.c2, p.c1, 2 * p.c0);
}

/// numerator / denominator, which is positive.
struct Fraction {
    Exact numerator;
    Exact denominator;

    friend bool operator<(const Fraction& a, const Fraction& b) {
        return a.numerator * b.denominator < b.numerator * a.denominator;
    }
};

ExactVector area(const Triangle& triangle) {
    return cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

}  // namespace

bool contains(const Interval& interval, const Root& t) {
    return t.sign_of(-interval.min, 1) > 0 && (!interval.max || t.sign_of(-*interval.max, 1) < 0);
}

std::vector<Root> roots(const Ray& ray, const Sphere& sphere) {
    return roots(square(ray.origin - sphere.center, ray.direction) - squared(sphere.radius));
}

std::vector<Root> roots(const Ray& ray, const Plane& plane) {
    return roots(along(ray.origin - plane.point, ray.direction, plane.normal));
}

std::vector<Root> roots(const Ray& ray, const Triangle& triangle) {
    return roots(ray, Plane{.point = triangle.a, .normal = area(triangle)});
}

std::vector<Root> roots(const Ray& ray, const Square& square) {
    if (square.one_sided && dot(ray.direction, square.z).sign() >= 0) return {};
    return roots(ray, Plane{.point = square.center, .normal = square.z});
}

std::vector<Root> roots(const Ray& ray, const Cylinder& cylinder) {
    const ExactVector o = ray.origin - cylinder.center;
    const Exact axis_squared = dot(cylinder.axis, cylinder.axis);
    return roots(across(o, ray.direction, cylinder.axis) - axis_squared * squared(cylinder.radius));
}

std::vector<Root> roots(const Ray& ray, const Cone& cone) {
    const ExactVector o = ray.origin - cone.apex;
    return roots(squared(cone.height) * across(o, ray.direction, cone.axis) -
                 squared(cone.radius) * squared(along(o, ray.direction, cone.axis)));
}

std::vector<Root> roots(const Ray& ray, const OrientedBox& box) {
    const ExactVector o = ray.origin - box.center;
    std::vector<Root> crossings;
    const auto add_faces = [&](const ExactVector& axis, const Exact& half) {
        const Polynomial place = along(o, ray.direction, axis);
        if (place.c1.sign() == 0) return;
        for (const Exact& face : {half, -half}) {
            const Root t(face - place.c0, place.c1);
            if (belongs(ray, box, t)) crossings.push_back(t);
        }
    };
    add_faces(box.x, box.half_size.x);
    add_faces(box.y, box.half_size.y);
    add_faces(box.z, box.half_size.z);
    std::ranges::sort(crossings, {}, &Root::value);
    return crossings;
}

bool belongs(const Ray& /*ray*/, const Sphere& /*sphere*/, const Root& /*t*/) {
    return true;
}

bool belongs(const Ray& /*ray*/, const Plane& /*plane*/, const Root& /*t*/) {
    return true;
}

bool belongs(const Ray& ray, const Triangle& triangle, const Root& t) {
    // On the inner side of every edge, in the plane: ⟨n × edge, p − corner⟩ ≥ 0.
    const ExactVector n = area(triangle);
    const auto inside = [&](const ExactVector& p, const ExactVector& q) {
        return sign_at(t, along(ray.origin - p, ray.direction, cross(n, q - p))) >= 0;
    };
    return inside(triangle.a, triangle.b) && inside(triangle.b, triangle.c) &&
           inside(triangle.c, triangle.a);
}

bool belongs(const Ray& ray, const Square& square, const Root& t) {
    const auto inside = [&](const ExactVector& axis) {
        const Polynomial place = along(ray.origin - square.center, ray.direction, axis);
        return sign_at(t, 2 * place - square.side) <= 0 &&
               sign_at(t, -2 * place - square.side) <= 0;
    };
    return inside(square.x) && inside(square.y);
}

bool belongs(const Ray& ray, const Cylinder& cylinder, const Root& t) {
    const Polynomial z = along(ray.origin - cylinder.center, ray.direction, cylinder.axis);
    const Exact limit = squared(cylinder.height) * dot(cylinder.axis, cylinder.axis);
    return sign_at(t, 4 * squared(z) - limit) <= 0;
}

bool belongs(const Ray& ray, const Cone& cone, const Root& t) {
    const Polynomial z = along(ray.origin - cone.apex, ray.direction, cone.axis);
    const Exact limit = squared(cone.height) * dot(cone.axis, cone.axis);
    return sign_at(t, z) >= 0 && sign_at(t, squared(z) - limit) <= 0;
}

bool belongs(const Ray& ray, const OrientedBox& box, const Root& t) {
    const auto inside = [&](const ExactVector& axis, const Exact& half) {
        const Polynomial place = along(ray.origin - box.center, ray.direction, axis);
        return sign_at(t, place - half) <= 0 && sign_at(t, Exact(-1) * place - half) <= 0;
    };
    return inside(box.x, box.half_size.x) && inside(box.y, box.half_size.y) &&
           inside(box.z, box.half_size.z);
}

NumberVector normal(const Sphere& sphere, const ExactVector& point) {
    return unit(point - sphere.center);
}

NumberVector normal(const Plane& plane, const ExactVector& /*point*/) {
    return unit(plane.normal);
}

NumberVector normal(const Triangle& triangle, const ExactVector& /*point*/) {
    return unit(area(triangle));
}

NumberVector normal(const Square& square, const ExactVector& /*point*/) {
    return unit(square.z);
}

NumberVector normal(const Cylinder& cylinder, const ExactVector& point) {
    const ExactVector& z = cylinder.axis;
    return unit(cross(z, cross(point - cylinder.center, z)));
}

NumberVector normal(const Cone& cone, const ExactVector& point) {
    const ExactVector& z = cone.axis;
    const ExactVector outward = cross(z, cross(point - cone.apex, z));
    if (is_zero(outward)) return -unit(z);
    const Number slant = sqrt((squared(cone.radius) + squared(cone.height)).number());
    return Number(cone.height.number() / slant) * unit(outward) -
           Number(cone.radius.number() / slant) * unit(z);
}

NumberVector color_from_normal(const ExactVector& normal) {
    const NumberVector n = unit(normal);
    return {abs(n.x), abs(n.y), abs(n.z)};
}

Number torch(const ExactVector& point, const ExactVector& normal, const ExactVector& eye) {
    const ExactVector to_eye = eye - point;
    const Exact cosine = dot(normal, to_eye);
    if (cosine.sign() <= 0) return 0;
    return cosine.number() / sqrt((dot(normal, normal) * dot(to_eye, to_eye)).number());
}

NumberVector barycentric(const Triangle& triangle, const ExactVector& point) {
    // Least squares: β and γ from the edges' scalar products alone.
    const ExactVector u = triangle.b - triangle.a;
    const ExactVector v = triangle.c - triangle.a;
    const ExactVector p = point - triangle.a;
    const Exact whole = dot(u, u) * dot(v, v) - squared(dot(u, v));
    const Exact beta = dot(p, u) * dot(v, v) - dot(p, v) * dot(u, v);
    const Exact gamma = dot(p, v) * dot(u, u) - dot(p, u) * dot(u, v);
    const auto share = [&](const Exact& part) { return Number(part.number() / whole.number()); };
    return {share(whole - beta - gamma), share(beta), share(gamma)};
}

std::array<Number, 2> square_uv(const Square& square, const ExactVector& point) {
    const ExactVector p = point - square.center;
    const auto share = [&](const ExactVector& axis) {
        return Number((2 * dot(p, axis) + square.side).number() / (2 * square.side).number());
    };
    return {share(square.x), share(square.y)};
}

NumberVector mirrored(const ExactVector& direction, const ExactVector& normal) {
    const Exact square = dot(normal, normal);
    const ExactVector scaled = square * direction - 2 * dot(direction, normal) * normal;
    return Number(1 / square.number()) * number(scaled);
}

bool overlap(const Ray& ray, const ExactVector& min, const ExactVector& max,
             const Interval& interval) {
    Fraction first{interval.min, 1};
    std::optional<Fraction> last;
    if (interval.max) last = Fraction{*interval.max, 1};
    // The t with o + t d ≥ low, for one coordinate; an upper bound is the lower one of the
    // opposite.
    const auto keep = [&](const Exact& o, const Exact& d, const Exact& low) {
        if (d.sign() == 0) return o >= low;
        if (d.sign() > 0) first = std::max(first, Fraction{low - o, d});
        if (d.sign() < 0 && !last) last = Fraction{o - low, -d};
        if (d.sign() < 0) last = std::min(*last, Fraction{o - low, -d});
        return true;
    };
    const auto& [o, d] = ray;
    return keep(o.x, d.x, min.x) && keep(-o.x, -d.x, -max.x) &&  //
           keep(o.y, d.y, min.y) && keep(-o.y, -d.y, -max.y) &&  //
           keep(o.z, d.z, min.z) && keep(-o.z, -d.z, -max.z) && (!last || !(*last < first));
}

}  // namespace rt::oracle

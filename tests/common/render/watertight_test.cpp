// Stage 5's reference is watertight: no ray passes between triangles that share an edge or a corner
// (docs/step05_triangle.md). Students' need not be: the textbook's forms are right in every suite,
// and here they leak.
#include "steps/step05_triangle/triangle.hpp"

#include "tests/kit/meshes.hpp"
#include "tests/kit/shape_checks.hpp"

#include <algorithm>
#include <vector>

using namespace rt;

namespace {

using Face = std::array<std::uint32_t, 3>;

const Mesh& ball() {
    static const Mesh mesh = refined(refined(refined(octahedron())));
    return mesh;
}

/// The faces that touch each point.
const std::vector<std::vector<Face>>& faces_around() {
    static const auto around = [] {
        std::vector<std::vector<Face>> faces(ball().vertices.size());
        for (const Face& face : ball().triangles)
            for (const std::uint32_t corner : face) faces[corner].push_back(face);
        return faces;
    }();
    return around;
}

enum class Target { edge, corner };

/// A ray to a point that faces share, and every face that touches the shared vertex or edge. These
/// cover the neighborhood of the point, so the ray hits one of them.
struct AimedRay {
    Ray ray;
    std::vector<Triangle> around;
};

AimedRay draw_shot(Random& random, Target target) {
    const std::vector<Vec3>& points = ball().vertices;
    const auto& faces = ball().triangles;
    const Face face = faces[std::size_t(random.below(int(faces.size())))];
    const int corner = random.below(3);
    const std::uint32_t p = face[std::size_t(corner)];
    const std::uint32_t q = target == Target::edge ? face[std::size_t((corner + 1) % 3)] : p;
    const Real share = random.between(Real(0.05), Real(0.95));

    const Transform transform = random_motion(random);
    const Vec3 aim = transformed(points[p] + share * (points[q] - points[p]), transform);
    const Vec3 normal = rotated(points[p], transform);
    Vec3 away = random.direction();  // to inside or outside, and not along the surface
    if (std::abs(dot(away, normal)) < Real(0.5)) away += dot(away, normal) < 0 ? -normal : normal;
    const Vec3 origin = aim + transform.scale * random.between(Real(0.25), 4) * away;

    AimedRay shot{.ray = {.origin = origin, .direction = aim - origin}};
    for (const std::uint32_t end : {p, q})
        for (const auto& [a, b, c] : faces_around()[end])
            shot.around.push_back({transformed(points[a], transform),
                                   transformed(points[b], transform),
                                   transformed(points[c], transform)});
    return shot;
}

/// Half-planes (MRT §5), with the edges.
std::optional<Real> by_half_planes(const Ray& ray, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    const Vec3 p = at(ray, t);
    if (!(dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
          dot(cross(a - c, p - c), n) >= 0))
        return std::nullopt;
    return t;
}

/// Barycentric coordinates (M1; Möller, Trumbore 1997), with the edges.
std::optional<Real> by_moller_trumbore(const Ray& ray, const Triangle& triangle) {
    const Vec3 ab = triangle.b - triangle.a;
    const Vec3 ac = triangle.c - triangle.a;
    const Vec3 q = cross(ray.direction, ac);
    const Vec3 s = ray.origin - triangle.a;
    const Vec3 r = cross(s, ab);
    const Real inverse = 1 / dot(ab, q);
    const Real beta = dot(s, q) * inverse;
    const Real gamma = dot(ray.direction, r) * inverse;
    if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
    return dot(ac, r) * inverse;
}

using Way = std::optional<Real> (*)(const Ray&, const Triangle&);

bool leaks(const AimedRay& shot, Way way) {
    return std::ranges::none_of(
        shot.around, [&](const Triangle& triangle) { return way(shot.ray, triangle).has_value(); });
}

std::optional<Real> by_reference(const Ray& ray, const Triangle& triangle) {
    return intersect(ray, triangle, {});
}

Verdict is_stopped(const AimedRay& shot) {
    return verdict(!leaks(shot, by_reference),
                   code(shot.ray) + " hits none of the " + std::to_string(shot.around.size()) +
                       " triangles around the point it is aimed at; the first of them is " +
                       code(shot.around.front()));
}

/// The percentage of rays that leak.
double leaking_share(Target target, Way way) {
    constexpr int shots = 20'000;
    int leaking = 0;
    for (std::uint64_t seed = 0; seed < shots; ++seed) {
        Random random(seed);
        if (leaks(draw_shot(random, target), way)) ++leaking;
    }
    return 100.0 * leaking / shots;
}

}  // namespace

TEST_CASE("no ray passes between two triangles that share an edge (contract)") {
    CHECK(for_all([](Random& random) { return is_stopped(draw_shot(random, Target::edge)); },
                  500'000));
}

TEST_CASE("no ray passes between the triangles that share a corner (contract)") {
    CHECK(for_all([](Random& random) { return is_stopped(draw_shot(random, Target::corner)); },
                  500'000));
}

TEST_CASE("neither does any at another scale, though areas leave float's range (contract)") {
    // float's smallest normal number is 2^-126, its largest 2^128: 2^±100, and 2^±10 from the
    // motion, leave room for the distance of the origin and for a face's share of the ball.
    CHECK(for_all(
        [](Random& random) {
            AimedRay shot = draw_shot(random, random.coin() ? Target::edge : Target::corner);
            const Real scale = std::ldexp(Real(1), random.below(201) - 100);
            shot.ray.origin *= scale;
            shot.ray.direction *= scale * random.power_of_two();
            for (auto& [a, b, c] : shot.around) {
                a *= scale;
                b *= scale;
                c *= scale;
            }
            return is_stopped(shot);
        },
        20'000));
}

TEST_CASE("of a hundred such rays, five to ten pass the textbook's forms (MRT §5, M1)") {
    for (const Target target : {Target::edge, Target::corner}) {
        for (const Way way : {by_half_planes, by_moller_trumbore}) {
            const double share = leaking_share(target, way);
            CHECK(share > 4.5);
            CHECK(share < 11);
        }
    }
}

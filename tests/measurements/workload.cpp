#include "tests/measurements/workload.hpp"

#include "scenes/meshes/surfaces.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <random>

namespace measurements {

namespace {

using glm::vec3;

constexpr float far_away = 1e30F;

vec3 vec(const Point& p) {
    return {p[0], p[1], p[2]};
}

Point point(vec3 v) {
    return {v.x, v.y, v.z};
}

vec3 displaced(vec3 p) {
    p = glm::normalize(p);
    const float slow = std::sin(7 * p.x + 1) * std::sin(6 * p.y) * std::sin(8 * p.z + 2);
    const float quick = std::sin(31 * p.x) * std::sin(29 * p.y + 1) * std::sin(37 * p.z);
    return p * (1 + 0.08F * slow + 0.02F * quick);
}

class Draw {
public:
    float between(float low, float high) { return low + (high - low) * uniform_(engine_); }

    vec3 direction() {
        const float z = between(-1, 1);
        const float angle = between(0, 6.2831853F);
        const float r = std::sqrt(std::max(0.0F, 1 - z * z));
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::mt19937 engine_{2021};
    std::uniform_real_distribution<float> uniform_{0, 1};
};

std::vector<RayQuery> primary_rays(vec3 eye) {
    constexpr int width = 640;
    constexpr int height = 480;
    const vec3 forward = glm::normalize(-eye);
    const vec3 right = glm::normalize(glm::cross(forward, vec3(0, 1, 0)));
    const vec3 up = glm::cross(right, forward);
    std::vector<RayQuery> rays;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const float x = (float(column) + 0.5F) / width - 0.5F;
            const float y = 0.5F - (float(row) + 0.5F) / height;
            const vec3 direction = forward + x * 1.3333F * right + y * up;
            rays.push_back({point(eye), point(glm::normalize(direction)), far_away});
        }
    return rays;
}

}  // namespace

TriangleMesh displaced_sphere(int frequency) {
    const rt::Polygons flat = rt::cut_icosahedron(frequency);
    TriangleMesh mesh;
    for (const glm::dvec3& vertex : flat.vertices)
        mesh.vertices.push_back(point(displaced(vec3(vertex))));
    for (const std::vector<int>& face : flat.faces)
        mesh.triangles.push_back(
            {std::uint32_t(face[0]), std::uint32_t(face[1]), std::uint32_t(face[2])});
    return mesh;
}

std::vector<RaySet> ray_sets(const TriangleMesh& mesh, const Engine& engine) {
    const vec3 light(-5, 8, 6);
    RaySet primary{.name = "primary", .rays = primary_rays({0, 0.3F, 2.6F})};
    RaySet diffuse{.name = "diffuse"};
    RaySet random{.name = "random"};
    RaySet shadow{.name = "shadow", .shadow = true};
    Draw draw;
    for (const RayQuery& ray : primary.rays) {
        const NearestHit hit = engine.nearest(ray);
        if (hit.triangle == NearestHit::none) continue;
        const auto& [a, b, c] = mesh.triangles[hit.triangle];
        vec3 normal = glm::normalize(glm::cross(vec(mesh.vertices[b]) - vec(mesh.vertices[a]),
                                                vec(mesh.vertices[c]) - vec(mesh.vertices[a])));
        if (glm::dot(normal, vec(ray.direction)) > 0) normal = -normal;
        const vec3 from = vec(ray.origin) + hit.t * vec(ray.direction) + 1e-3F * normal;
        shadow.rays.push_back({point(from), point(light - from), 1});
        for (int i = 0; i < 2; ++i)
            diffuse.rays.push_back(
                {point(from), point(glm::normalize(draw.direction() + 1.001F * normal)), far_away});
    }
    while (random.rays.size() < primary.rays.size()) {
        const vec3 from = 3.0F * draw.direction();
        const vec3 to = 1.3F * std::cbrt(draw.between(0, 1)) * draw.direction();
        random.rays.push_back({point(from), point(glm::normalize(to - from)), far_away});
    }
    return {primary, diffuse, random, shadow};
}

std::vector<RayQuery> rays_at_edges(const TriangleMesh& mesh) {
    const vec3 from(0.031F, -0.017F, 0.023F);
    Draw draw;
    std::vector<RayQuery> rays;
    const auto aim = [&](vec3 at) { rays.push_back({point(from), point(at - from), far_away}); };
    for (const Point& vertex : mesh.vertices) aim(vec(vertex));
    for (const auto& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            if (triangle[i] > triangle[(i + 1) % 3]) continue;  // the other triangle's turn
            const vec3 a = vec(mesh.vertices[triangle[i]]);
            const vec3 b = vec(mesh.vertices[triangle[(i + 1) % 3]]);
            aim(a + 0.5F * (b - a));
            aim(a + draw.between(0, 1) * (b - a));
        }
    return rays;
}

}  // namespace measurements

// The Raysteps engine, in the precision of this compilation.
#include "common/bvh/mesh_bvh.hpp"

#include "tests/measurements/workload.hpp"

namespace measurements {

namespace {

using namespace rt;

Vec3 vec(const Point& p) {
    return {Real(p[0]), Real(p[1]), Real(p[2])};
}

Ray ray_of(const RayQuery& query) {
    return {.origin = vec(query.origin), .direction = vec(query.direction)};
}

class PackedEngine : public Engine {
public:
    void build(const TriangleMesh& mesh) override {
        Mesh ours{.triangles = mesh.triangles};
        for (const Point& vertex : mesh.vertices) ours.vertices.push_back(vec(vertex));
        build(ours);
    }

    void build(const Mesh& mesh) { mesh_ = MeshBvh(mesh); }

    [[nodiscard]] NearestHit nearest(const RayQuery& query) const override {
        const auto hit = mesh_.nearest(ray_of(query), {.max = Real(query.max)});
        if (!hit) return {};
        return {.t = float(hit->t), .triangle = hit->triangle};
    }

    [[nodiscard]] std::size_t count_nearest(const RayQuery* rays, std::size_t n) const override {
        std::size_t hits = 0;
        for (std::size_t i = 0; i < n; ++i)
            if (mesh_.nearest(ray_of(rays[i]), {.max = Real(rays[i].max)})) ++hits;
        return hits;
    }

    [[nodiscard]] std::size_t count_blocked(const RayQuery* rays, std::size_t n) const override {
        std::size_t blocked = 0;
        for (std::size_t i = 0; i < n; ++i)
            if (mesh_.occludes(ray_of(rays[i]), {.max = Real(rays[i].max)})) ++blocked;
        return blocked;
    }

private:
    MeshBvh mesh_;
};

}  // namespace

#ifdef RT_FLOAT
std::unique_ptr<Engine> float_engine() {
#else
std::unique_ptr<Engine> double_engine() {
#endif
    return std::make_unique<PackedEngine>();
}

}  // namespace measurements

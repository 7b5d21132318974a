// Embree 3, one ray at a time, in its default mode.
#include "tests/measurements/workload.hpp"

#ifdef RAYSTEPS_EMBREE

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>

namespace measurements {

namespace {

RTCRay embree_ray(const RayQuery& query) {
    const auto& [o, d, max] = query;
    return {.org_x = o[0],
            .org_y = o[1],
            .org_z = o[2],
            .tnear = 0,
            .dir_x = d[0],
            .dir_y = d[1],
            .dir_z = d[2],
            .time = 0,
            .tfar = max,
            .mask = ~0U,
            .id = 0,
            .flags = 0};
}

class EmbreeEngine : public Engine {
public:
    EmbreeEngine() : device_(rtcNewDevice("threads=2")) {}
    EmbreeEngine(const EmbreeEngine&) = delete;
    EmbreeEngine& operator=(const EmbreeEngine&) = delete;
    ~EmbreeEngine() override {
        if (scene_ != nullptr) rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    void build(const TriangleMesh& mesh) override {
        if (scene_ != nullptr) rtcReleaseScene(scene_);
        scene_ = rtcNewScene(device_);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const auto fill = [&](RTCBufferType type, RTCFormat format, const auto& items) {
            std::memcpy(
                rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof items[0], items.size()),
                items.data(), sizeof items[0] * items.size());
        };
        fill(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices);
        fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }

    [[nodiscard]] NearestHit nearest(const RayQuery& query) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        return nearest(query, context);
    }

    [[nodiscard]] std::size_t count_nearest(const RayQuery* rays, std::size_t n) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        return std::size_t(std::count_if(rays, rays + n, [&](const RayQuery& query) {
            return nearest(query, context).triangle != NearestHit::none;
        }));
    }

    [[nodiscard]] std::size_t count_blocked(const RayQuery* rays, std::size_t n) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        return std::size_t(std::count_if(rays, rays + n, [&](const RayQuery& query) {
            RTCRay ray = embree_ray(query);
            rtcOccluded1(scene_, &context, &ray);
            return ray.tfar < 0;
        }));
    }

private:
    NearestHit nearest(const RayQuery& query, RTCIntersectContext& context) const {
        RTCRayHit ray;
        ray.ray = embree_ray(query);
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        return {.t = ray.ray.tfar, .triangle = ray.hit.primID};
    }

    RTCDevice device_;
    RTCScene scene_ = nullptr;
};

}  // namespace

std::unique_ptr<Engine> embree_engine() {
    return std::make_unique<EmbreeEngine>();
}

}  // namespace measurements

#else

namespace measurements {

std::unique_ptr<Engine> embree_engine() {
    return nullptr;
}

}  // namespace measurements

#endif

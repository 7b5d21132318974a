#include "common/render/watch.hpp"

#include "common/explain/pixel_log.hpp"
#include "common/explain/ray_records.hpp"
#include "common/math/vector.hpp"

namespace rt {

void watch_ray(const Context& context, const Ray& ray) {
    const RayKind kind = context.bounces == 0 ? RayKind::eye : RayKind::mirrored;
    if (RayRecords* const records = context.watch->records)
        begin(*records, kind, context.rays, context.bounces, ray, infinity);
}

void begin_shadow_ray(const Context& context, const Ray& ray, Interval interval) {
    RayRecords* const records = context.watch->records;
    if (records == nullptr) return;
    if (records->rays.empty() || records->rays.back().number != context.rays)
        begin(*records, RayKind::shadow, context.rays, context.bounces, ray, interval.max);
}

void watch_hit(const Watch& watch, const Ray& ray, const void* primitive, Real t, Vec3 point,
               Vec3 normal) {
    if (watch.log != nullptr) return explain_hit(*watch.log, point, normal);
    RayRecord& record = closest_record(*watch.records, ray);
    record.shape = primitive;
    record.t = double(t);
    record.point = numbers(point);
    record.normal = numbers(normal);
}

}  // namespace rt

#include "common/render/watch.hpp"

#include "common/explain/pixel_log.hpp"
#include "common/explain/ray_records.hpp"
#include "common/math/vector.hpp"

namespace rt {

void watch_ray(const Context& context, const Ray& ray) {
    if (PixelLog* const log = context.watch->log) {
        if (context.rays == 1) return;  // the pixel's ray, which is logged
        log->heading(context.bounces == 0
                         ? "Another ray"
                         : "The ray after " + std::to_string(context.bounces) +
                               (context.bounces == 1 ? " reflection" : " reflections"));
        if (context.bounces > 0) {
            log->line("d, before the mirror", log->direction);
            log->line("n, of the mirror", log->normal);
        }
        log->line("o_r", text(ray.origin));
        log->line("d_r", text(ray.direction));
    }
    const RayKind kind = context.bounces == 0 ? RayKind::eye : RayKind::mirrored;
    if (RayRecords* const records = context.watch->records)
        begin(*records, kind, context.rays, context.bounces, ray, infinity);
}

void begin_shadow_ray(const Context& context, const Ray& ray, Interval interval) {
    const auto& [log, records] = *context.watch;
    if (log != nullptr && log->shadow_test(context.rays) == PixelLog::ShadowTest::first_of_ray) {
        log->line("the shadow ray's origin", text(ray.origin));
        log->line("the shadow ray's direction", text(ray.direction));
        log->line("the shadow ray's interval",
                  "(" + text(interval.min) + ", " + text(interval.max) + ")");
    }
    if (records == nullptr) return;
    if (records->rays.empty() || records->rays.back().number != context.rays)
        begin(*records, RayKind::shadow, context.rays, context.bounces, ray, interval.max);
}

void watch_hit(const Watch& watch, const Ray& ray, const void* primitive, Real t, Vec3 point,
               Vec3 normal) {
    if (watch.log != nullptr) {
        watch.log->surface = primitive;
        watch.log->direction = text(ray.direction);
        watch.log->normal = text(face_forward(normal, ray.direction));
        return explain_hit(*watch.log, point, normal);
    }
    RayRecord& record = closest_record(*watch.records, ray);
    record.shape = primitive;
    record.t = double(t);
    record.point = numbers(point);
    record.normal = numbers(normal);
}

}  // namespace rt

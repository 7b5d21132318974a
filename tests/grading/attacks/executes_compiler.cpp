// attack: becomes the compiler, or what starts programs, by an absolute path beside a descriptor
// ceiling: as a stub
// stage: step13_meshes
// message without: ended the program
#include "steps/step13_meshes/meshes.hpp"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rt {

namespace {

constexpr const char* programs[] = {
    "/usr/lib/gcc/x86_64-linux-gnu/12/cc1plus", "/usr/lib/gcc/x86_64-linux-gnu/13/cc1plus",
    "/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1", "/bin/true"};

}  // namespace

std::optional<Interval> overlap(const Ray&, const BoundingBox&, Interval) {
    constexpr int own_program = 9;
    char* nothing[] = {nullptr};
    for (const char* program : programs)
        (void)syscall(SYS_execveat, own_program, program, nothing, nothing, AT_EMPTY_PATH);
    return std::nullopt;
}

std::optional<Real> intersect(const Ray&, const OrientedBox&, Interval) {
    return std::nullopt;
}

Vec3 normal(const OrientedBox&, Vec3) {
    return Vec3(0);
}

Ray to_object_space(const Ray& ray, const Transform&) {
    return ray;
}

std::optional<MeshHit> intersect(const Ray&, const Mesh&, Interval) {
    return std::nullopt;
}

Vec3 interpolated_normal(const std::array<Vec3, 3>&, Vec3) {
    return Vec3(0);
}

}  // namespace rt

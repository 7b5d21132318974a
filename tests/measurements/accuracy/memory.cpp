// The bytes of rays and shapes, and those that the scenes take, with their meshes and hierarchies.
#include "common/program/load_meshes.hpp"
#include "common/scene/scene.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/accuracy/forms.hpp"

#include <malloc.h>

#include <cstdio>

using namespace rt;

namespace {

/// The bytes in use, of glibc's allocator.
std::size_t allocated() {
    const auto all = mallinfo2();
    return all.uordblks + all.hblkhd;
}

void print(const char* what, std::size_t bytes) {
    std::printf("%s,%s,%zu\n", what, precision_word, bytes);
}

void measure(const char* name) {
    const std::size_t before = allocated();
    Scene scene =
        load_scene(RAYSTEPS_ROOT "/scenes/" + std::string(name) + ".rt", orthonormal_basis);
    load_meshes(scene);
    build_acceleration(scene);
    print(name, allocated() - before);
}

}  // namespace

int main() {
    std::puts("what,precision,bytes");
    print("a ray", sizeof(Ray));
    print("a sphere", sizeof(Sphere));
    print("a triangle", sizeof(Triangle));
    print("a cone", sizeof(Cone));
    for (const char* scene : {"cornell_box", "step12_mirror", "step13_meshes"}) measure(scene);
}

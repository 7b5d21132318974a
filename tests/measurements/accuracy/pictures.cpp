// Every scene of the project rendered in float, in double and by the certified kernels: the number
// of pixels that differ from the certified picture, and the time of each.
#include "tests/measurements/accuracy/drawing.hpp"

#include <cstdio>
#include <stdexcept>

using namespace rt;

namespace {

constexpr Resolution size{.width = 240, .height = 180};

/// The next picture from measure_exact_pictures, a separate program: its kernels have the names of
/// the references.
Drawing certified(std::FILE* other) {
    Drawing drawing{.image = Image(size)};
    auto& pixels = drawing.image.pixels;
    if (std::fread(&drawing.seconds, sizeof drawing.seconds, 1, other) != 1 ||
        std::fread(pixels.data(), sizeof pixels[0], pixels.size(), other) != pixels.size())
        throw std::runtime_error("measure_exact_pictures fails");
    return drawing;
}

void print(const std::string& scene, const char* precision, const Drawing& drawing,
           const Drawing& exact) {
    const Difference off = difference(drawing.image, exact.image);
    std::printf("%s,%s,%.4f,%.4g,%d,%.5f,%.5f,%.5f\n", scene.c_str(), precision, drawing.seconds,
                off.error, off.most, off.other, off.seen, off.edges);
}

}  // namespace

int main(int /*count*/, char** arguments) {
    const auto beside =
        std::filesystem::path(arguments[0]).parent_path() / "measure_exact_pictures";
    std::FILE* const other = popen(("'" + beside.string() + "'").c_str(), "r");
    if (other == nullptr) return 1;
    std::puts("scene,precision,seconds,error,most,other,seen,edges");
    for (const auto& scene : all_scenes()) {
        const Drawing exact = certified(other);
        print(scene.stem(), "float", f32::rendered(scene, size, {}), exact);
        print(scene.stem(), "double", f64::rendered(scene, size, {}), exact);
        print(scene.stem(), "exact", exact, exact);
    }
    return pclose(other);
}

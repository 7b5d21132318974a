// Stage 12's own picture, mirror upon mirror 0 to 16 times: how far it is from one with no end, and
// how long it takes.
#include "tests/measurements/accuracy/drawing.hpp"

#include <cstdio>

using namespace rt;

int main() {
    constexpr Resolution size{.width = 160, .height = 120};
    const std::string scene = RAYSTEPS_ROOT "/scenes/step12_mirror.rt";
    const Image endless = f64::rendered(scene, size, {.depth = 1000}).image;
    std::puts("depth,seconds,error,most,seen");
    for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 16}) {
        const Drawing drawing = f64::rendered(scene, size, {.depth = depth});
        const Difference off = difference(drawing.image, endless);
        std::printf("%d,%.4f,%.4g,%d,%.5f\n", depth, drawing.seconds, off.error, off.most,
                    off.seen);
    }
}

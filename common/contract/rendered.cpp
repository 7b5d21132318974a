#include "common/contract/rendered.hpp"

#include "common/render/render.hpp"

#include <utility>

namespace rt {

Image rendered(const Scene& scene, const RenderSettings& settings, int every) {
    if (auto own = picture_by_own_loop(scene)) return *std::move(own);
    const auto pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    Image image(scene.resolution);
    Context context{.settings = settings};
    for (Pixel& pixel = context.pixel; pixel.row < scene.resolution.height; pixel.row += every)
        for (pixel.column = 0; pixel.column < scene.resolution.width; pixel.column += every)
            image[pixel] = to_rgb(trace(scene, pixel_ray(pixel), context));
    return image;
}

Color traced(const Scene& scene, const RenderSettings& settings) {
    Context context{.settings = settings};
    return trace(scene, pixel_rays(scene.cameras.front(), scene.resolution)(context.pixel),
                 context);
}

}  // namespace rt

#include "common/contract/drawn.hpp"

#include "common/render/render.hpp"

namespace rt {

Image drawn(const Scene& scene, const Look& look, int every) {
    const auto pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    Image image(scene.resolution);
    Context context{.look = look};
    for (Pixel& pixel = context.pixel; pixel.row < scene.resolution.height; pixel.row += every)
        for (pixel.column = 0; pixel.column < scene.resolution.width; pixel.column += every)
            image[pixel] = to_rgb(trace(scene, pixel_ray(pixel), context));
    return image;
}

}  // namespace rt

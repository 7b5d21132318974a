// The program's use of this stage: one call of the loop in main.cpp or, on several threads, the
// ray and the color of each pixel.
#include "common/render/stage.hpp"
#include "common/system/input_error.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

#include <string>

namespace rt {

namespace {

std::string size_text(std::size_t pixels, Resolution size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height) + " with " +
           std::to_string(pixels) + " pixels";
}

}  // namespace

PixelRays pixel_rays(const Camera& camera, Resolution resolution) {
    return {.resolution = resolution, .vertical_fov = vertical_fov(camera, resolution)};
}

Ray PixelRays::operator()(Pixel pixel) const {
    return camera_ray(pixel, resolution, vertical_fov);
}

std::optional<Image> picture_by_own_loop(const Scene& scene) {
    const Resolution size = scene.resolution;
    Image image = render(size, vertical_fov(scene.cameras.front(), size));
    const auto [width, height] = image.resolution;
    const std::size_t pixels = Image(size).pixels.size();
    if (width != size.width || height != size.height || image.pixels.size() != pixels)
        throw InputError({}, "render returned an image of " +
                                 size_text(image.pixels.size(), image.resolution) + ", expected " +
                                 size_text(pixels, size));
    return image;
}

Color trace(const Scene& /*scene*/, const Ray& ray, Context& context) {
    ++context.rays;
    return direction_color(ray);
}

}  // namespace rt

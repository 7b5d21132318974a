// The visible share of an area light: its error and its time, for 1 to 1024 shadow rays that are
// spread by four methods. In stage 11's own scene.
#include "common/geometry/projection.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

using namespace rt;

namespace {

constexpr Resolution size{.width = 80, .height = 60};
constexpr int rays_for_truth = 8192;

/// A surface that an area light may light.
struct Lit {
    ShadingPoint surface;
    Light light;
    Color color;  ///< the contribution of the whole light
    Pixel pixel;
    Real truth = 0;  ///< the visible share
};

bool is_blocked(const Scene& scene, const ShadowRay& way) {
    Context context;
    AnyHit any_hit(way.ray, way.interval, context);
    visit_shapes(any_hit, scene);
    return any_hit.found();
}

bool reaches(const Scene& scene, const Lit& lit, Vec2 sample) {
    const Vec3 aim = sample_light(lit.light, lit.surface.point, sample);
    return !is_blocked(scene, shadow_ray(lit.surface, aim));
}

std::uint32_t seed_of(const Lit& lit, int number) {
    return sample_seed(lit.pixel, 1, std::uint32_t(number));
}

// The methods of spreading: each returns the rays that it sent. `rays` is their number; the
// adaptive one sends up to 1024, until the estimated error of the color is below 1 / rays.

ShadowRays independent(const Scene& scene, const Lit& lit, int rays) {
    ShadowRays sent;
    for (; sent.sent < rays;
         ++sent.sent)  // the first of each sequence: the sequences are independent
        sent.reached += reaches(scene, lit, spread_sample(0, seed_of(lit, sent.sent)));
    return sent;
}

ShadowRays stratified(const Scene& scene, const Lit& lit, int rays) {
    const int side = int(std::lround(std::sqrt(rays)));
    ShadowRays sent;
    for (; sent.sent < rays; ++sent.sent) {
        const Vec2 cell(sent.sent % side, sent.sent / side);
        const Vec2 within = spread_sample(0, seed_of(lit, sent.sent));
        sent.reached += reaches(scene, lit, (cell + within) / Real(side));
    }
    return sent;
}

ShadowRays well_spread(const Scene& scene, const Lit& lit, int rays) {
    ShadowRays sent;
    const std::uint32_t seed = seed_of(lit, 0);
    for (; sent.sent < rays; ++sent.sent)
        sent.reached += reaches(scene, lit, spread_sample(std::uint32_t(sent.sent), seed));
    return sent;
}

ShadowRays adaptive(const Scene& scene, const Lit& lit, int rays) {
    ShadowRays sent;
    const Context context{.settings = {.shadow_error = 255.0 / rays}};
    const std::uint32_t seed = seed_of(lit, 0);
    while (sent.sent < 1024 && !accurate(sent, lit.color, context)) {
        sent.reached += reaches(scene, lit, spread_sample(std::uint32_t(sent.sent), seed));
        ++sent.sent;
    }
    return sent;
}

struct Way {
    const char* name;
    ShadowRays (*send)(const Scene& scene, const Lit& lit, int rays);
};

constexpr std::array ways = {Way{"independent", independent}, Way{"stratified", stratified},
                             Way{"well spread", well_spread}, Way{"adaptive", adaptive}};

std::vector<Lit> all_lit(const Scene& scene) {
    const auto ray_of = pixel_rays(scene.cameras.front(), size);
    std::vector<Lit> all;
    for (Pixel pixel; pixel.row < size.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < size.width; ++pixel.column) {
            const Ray ray = ray_of(pixel);
            Context context;
            ClosestHit closest(ray, context);
            visit_shapes(closest, scene);
            const auto hit = closest.hit();
            if (!hit) continue;
            const ShadingPoint surface = shading_point(*hit, ray);
            for (const Light& light : scene.lights) {
                const Color color = diffuse_term(surface, light) + specular_term(surface, light);
                if (light.radius > 0 && color != Color(0))
                    all.push_back(
                        {.surface = surface, .light = light, .color = color, .pixel = pixel});
            }
        }
    return all;
}

/// One line: over all surfaces, the rays that were sent to each, the time that they took, and the
/// error of the color in levels of 255, as the root of its mean square and at most.
void measure(const Scene& scene, const std::vector<Lit>& all, const Way& way, int rays) {
    double squares = 0;
    double most = 0;
    double sent = 0;
    const std::clock_t start = std::clock();
    for (const Lit& lit : all) {
        const ShadowRays result = way.send(scene, lit, rays);
        const double strongest = std::max({lit.color.r, lit.color.g, lit.color.b});
        const double error = 255 * strongest * std::abs(visibility(result) - lit.truth);
        squares += error * error;
        most = std::max(most, error);
        sent += result.sent;
    }
    const double microseconds = 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC;
    const auto count = double(all.size());
    std::printf("%s,%d,%.1f,%.4g,%.4g,%.4g\n", way.name, rays, sent / count, microseconds / count,
                std::sqrt(squares / count), most);
}

}  // namespace

int main() {
    const Scene scene =
        load_scene(RAYSTEPS_ROOT "/scenes/step11_soft_shadows.rt", orthonormal_basis);
    std::vector<Lit> all = all_lit(scene);
    for (Lit& lit : all) {
        // Another seed than those that are measured.
        ShadowRays sent;
        for (; sent.sent < rays_for_truth; ++sent.sent)
            sent.reached +=
                reaches(scene, lit, spread_sample(std::uint32_t(sent.sent), seed_of(lit, -1)));
        lit.truth = visibility(sent);
    }
    std::puts("way,asked,rays,microseconds,error,most");
    for (const int rays : {1, 4, 16, 64, 256, 1024})
        for (const Way& way : ways) measure(scene, all, way, rays);
}

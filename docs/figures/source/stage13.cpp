// Stage 13: the slabs of a box, a ray in a mesh's own frame, and boxes in boxes around an owl.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "common/bvh/bvh.hpp"
#include "common/geometry/transform.hpp"
#include "common/system/input_error.hpp"

#include "steps/step13_meshes/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace rt::figures {

namespace {

constexpr Interval line{.min = -infinity, .max = infinity};

/// From t_min to t_max between the two planes of the slab alone: along the other axes the box is
/// as long as can be.
Interval within_slab(const Ray& ray, const BoundingBox& box, glm::length_t axis) {
    BoundingBox slab{.min = Vec3(-100), .max = Vec3(100)};
    slab.min[axis] = box.min[axis];
    slab.max[axis] = box.max[axis];
    return overlap(ray, slab, line).value();
}

constexpr BoundingBox block{.min = {-1, Real(-0.6), -1}, .max = {1, Real(0.6), 1}};

struct Case {
    std::string_view letter;
    Ray ray;
    Real end;
    std::string_view meaning;
};

void draw_slabs(Sketch& sketch) {
    const auto [low, high] = block;
    sketch.polygon({{low.x, -2, 0}, {high.x, -2, 0}, {high.x, 2, 0}, {low.x, 2, 0}}, tint, no_pen);
    sketch.polygon({{-2.4, low.y, 0}, {2.4, low.y, 0}, {2.4, high.y, 0}, {-2.4, high.y, 0}}, tint,
                   no_pen);
    for (const Real x : {low.x, high.x}) sketch.line({x, -2, 0}, {x, 2, 0}, dashed);
    for (const Real y : {low.y, high.y}) sketch.line({-2.4, y, 0}, {2.4, y, 0}, dashed);
    sketch.polygon({{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}},
                   faint, {.width = 2});
}

void draw_case(Sketch& sketch, const Case& shown) {
    const auto& [letter, ray, end, meaning] = shown;
    const auto inside = overlap(ray, block, {});
    for (const glm::length_t axis : {0, 1}) {
        const Interval slab = within_slab(ray, block, axis);
        for (const Real t : {slab.min, slab.max}) {
            const bool hit = inside && std::abs(t - inside->min) < Real(1e-9);
            if (t > 0 && t < end) sketch.mark(at(ray, t), hit ? Mark::hit : Mark::refused);
        }
    }
    sketch.ray(ray, end);
    sketch.mark(ray.origin, Mark::given);
    sketch.label(ray.origin, {-10, 17}, letter, {.color = blue, .bold = true});
}

/// The two intervals above each other, over t, and their intersection.
void draw_intervals(Svg& svg, Vec2 place, const Case& shown) {
    constexpr Real unit = 44;
    const auto at_t = [&](Real t) {
        return place + Vec2(unit * std::clamp(t, Real(-2), Real(3)), 0);
    };
    const Vec2 zero = at_t(0);
    const Interval x = within_slab(shown.ray, block, 0);
    const Interval y = within_slab(shown.ray, block, 1);
    svg.line(zero + Vec2(0, -22), zero + Vec2(0, 22), thin);
    svg.text(zero + Vec2(0, -28), "$t$ = 0", {.color = gray, .size = 13});
    const auto bar = [&](Interval part, Real height, std::string_view name) {
        svg.line(at_t(part.min) + Vec2(0, height), at_t(part.max) + Vec2(0, height),
                 {.color = gray, .width = 5});
        svg.text(at_t(part.min) + Vec2(-6, height + 5), name, {.anchor = Anchor::end, .size = 13});
    };
    const Interval shared{.min = std::max(x.min, y.min), .max = std::min(x.max, y.max)};
    if (shared.min < shared.max)
        svg.polygon({at_t(shared.min) + Vec2(0, -19), at_t(shared.max) + Vec2(0, -19),
                     at_t(shared.max) + Vec2(0, 19), at_t(shared.min) + Vec2(0, 19)},
                    faint, no_pen);
    bar(x, -10, "$x$");
    bar(y, 10, "$y$");
    if (overlap(shown.ray, block, {})) svg.circle(at_t(shared.min), 4, red);
    svg.text(place + Vec2(-118, 5), shown.letter, {.color = blue, .bold = true});
    svg.text(place + Vec2(-100, 42), shown.meaning, {.anchor = Anchor::start, .size = 13});
}

}  // namespace

std::string box_slabs() {
    Svg svg({640, 400}, "Three rays at a box, and when each of them is in its two slabs");
    Sketch sketch(svg, {.place = {176, 190}, .scale = 72});
    const std::array cases = {
        Case{"A",
             {.origin = {-2.1, -1, 0}, .direction = {1.2, 0.6, 0}},
             Real(3.1),
             "they overlap: in the box"},
        Case{"B",
             {.origin = {-2.1, 0.35, 0}, .direction = {1.1, 1.1, 0}},
             Real(1.45),
             "out of $y$ before into $x$: a miss"},
        Case{"C",
             {.origin = {1.5, -0.85, 0}, .direction = {0.7, -0.5, 0}},
             Real(1.2),
             "they overlap at $t$ < 0: behind"},
    };
    draw_slabs(sketch);
    for (const Case& shown : cases) draw_case(sketch, shown);
    // C's line, backwards, is in the box.
    sketch.line(cases[2].ray.origin, at(cases[2].ray, -Real(2.2)), dashed);
    Real top = 74;
    for (const Case& shown : cases) {
        draw_intervals(svg, {500, top}, shown);
        top += 116;
    }
    const TextStyle note{.anchor = Anchor::start, .size = 13};
    sketch.mark({-2.15, -2.5, 0}, Mark::hit);
    sketch.label({-2.15, -2.5, 0}, {12, 5}, "enters the box", note);
    sketch.mark({-0.3, -2.5, 0}, Mark::refused);
    sketch.label({-0.3, -2.5, 0}, {12, 5}, "crosses another plane of a slab", note);
    return svg.source();
}

namespace {

/// The outline of a small house, whose orientation is visible.
const std::vector<Vec3> house = {{-0.5, -0.5, 0}, {0.5, -0.5, 0},  {0.5, 0.25, 0},
                                 {0.28, 0.47, 0}, {0.28, 0.72, 0}, {0.13, 0.72, 0},
                                 {0.13, 0.62, 0}, {0, 0.75, 0},    {-0.5, 0.25, 0}};

void draw_frame(Sketch& sketch, Vec3 origin, Vec3 x, Vec3 y) {
    sketch.arrow(origin, origin + x, {.color = green, .width = 1.5});
    sketch.arrow(origin, origin + y, {.color = green, .width = 1.5});
}

void draw_counted_ray(Sketch& sketch, const Ray& ray, Real hit) {
    sketch.ray(ray, Real(2.7));
    for (const int t : {1, 2}) {
        sketch.mark(at(ray, Real(t)), Mark::foot);
        sketch.label(at(ray, Real(t)), {4, -9}, std::to_string(t), {.color = gray, .size = 13});
    }
    sketch.mark(ray.origin, Mark::given);
    sketch.mark(at(ray, hit), Mark::hit);
}

}  // namespace

std::string mesh_frame() {
    Svg svg({640, 330},
            "A mesh turned and enlarged in the scene, and the ray carried into its frame");
    const Real angle = Real(0.42);
    const Transform placement{.rotation = {.x = {std::cos(angle), std::sin(angle), 0},
                                           .y = {-std::sin(angle), std::cos(angle), 0},
                                           .z = {0, 0, 1}},
                              .scale = Real(1.9),
                              .translation = {Real(0.75), Real(0.1), 0}};
    const Ray ray{.origin = {-2, Real(0.35), 0}, .direction = {1, Real(-0.2), 0}};
    const Ray seen = to_object_space(ray, placement);
    std::vector<Vec3> moved_house;
    for (const Vec3& corner : house) moved_house.push_back(transformed(corner, placement));
    // Its left wall, which extends towards the reader and away.
    const Mesh wall{.vertices = {house[0], house[8], {-0.5, 0, 1}, {-0.5, 0, -1}},
                    .triangles = {{0, 1, 2}, {0, 3, 1}}};
    const Real hit = intersect(seen, wall, {}).value().t;

    Sketch scene(svg, {.place = {170, 160}, .scale = 68});
    scene.polygon(moved_house, tint, {.width = 2});
    const Vec3& o = placement.translation;
    draw_frame(scene, o, placement.scale * Real(0.42) * placement.rotation.x,
               placement.scale * Real(0.42) * placement.rotation.y);
    draw_counted_ray(scene, ray, hit);
    scene.label(ray.origin, {-2, -12}, "$o_r$");
    Sketch frame(svg, {.place = {536, 176}, .scale = 68});
    frame.polygon(house, tint, {.width = 2});
    draw_frame(frame, Vec3(0), {Real(0.42), 0, 0}, {0, Real(0.42), 0});
    draw_counted_ray(frame, seen, hit);
    svg.text({170, 292}, "the scene");
    svg.text({500, 292}, "the mesh's frame");
    svg.text({320, 318},
             "the same $t$ at the same point: $d_r$ is turned and made smaller, not unit length",
             {.color = gray, .size = 13});
    return svg.source();
}

namespace {

using Polygon = std::vector<Vec3>;

/// The polygons of scenes/meshes/owl_cage.obj.
std::vector<Polygon> owl_cage() {
    const std::string file = RAYSTEPS_ROOT "/scenes/meshes/owl_cage.obj";
    std::ifstream in(file);
    if (!in) throw InputError({.file = file}, "cannot be read");
    std::vector<Vec3> vertices;
    std::vector<Polygon> polygons;
    for (std::string text; std::getline(in, text);) {
        std::istringstream words(text);
        std::string keyword;
        words >> keyword;
        if (keyword == "v") {
            Vec3 v;
            words >> v.x >> v.y >> v.z;
            vertices.push_back(v);
        } else if (keyword == "f") {
            polygons.emplace_back();
            for (std::size_t corner = 0; words >> corner;)
                polygons.back().push_back(vertices.at(corner - 1));
        }
    }
    return polygons;
}

BoundingBox box_around(const Polygon& polygon) {
    BoundingBox box;
    for (const Vec3& corner : polygon) box = merged(box, corner);
    return box;
}

/// The polygons that face a viewer along −z, the far ones first.
void draw_polygons(Sketch& sketch, std::vector<Polygon> polygons) {
    const auto depth = [](const Polygon& polygon) { return box_around(polygon).max.z; };
    std::ranges::sort(polygons, {}, depth);
    for (const Polygon& polygon : polygons)
        if (cross(polygon[1] - polygon[0], polygon[2] - polygon[0]).z > 0)
            sketch.polygon(polygon, tint, {.color = "#b3bcc6", .width = Real(0.6)});
}

void draw_box(Sketch& sketch, const BoundingBox& box, const Pen& pen) {
    const auto& [low, high] = box;
    sketch.polygon({{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}},
                   none, pen);
}

/// The boxes in the one around everything.
std::vector<BoundingBox> first_boxes(const Bvh& hierarchy, const std::vector<BoundingBox>& boxes) {
    const std::vector<Bvh::Part> parts = hierarchy.parts();
    std::vector<BoundingBox> around(parts.size());
    for (std::size_t place = parts.size(); place-- > 1;) {
        if (const auto leaf = parts[place].leaf)
            for (const std::uint32_t index : hierarchy.leaves()[*leaf].indices)
                if (index != Leaf::none) around[place] = merged(around[place], boxes[index]);
        BoundingBox& parent = around[parts[place].parent];
        parent = merged(parent, around[place]);
    }
    std::vector<BoundingBox> first;
    for (std::size_t place = 1; place < parts.size() && parts[place].parent == 0; ++place)
        first.push_back(around[place]);
    return first;
}

}  // namespace

std::string mesh_hierarchy() {
    Svg svg({640, 310}, "Boxes in boxes around an owl, and the few that a ray makes one look into");
    const std::vector<Polygon> polygons = owl_cage();
    std::vector<BoundingBox> boxes;
    for (const Polygon& polygon : polygons) boxes.push_back(box_around(polygon));
    const Bvh hierarchy(boxes.size(), [&boxes](std::size_t i) { return boxes[i]; });
    const auto view = [](Real x) { return View{.place = {x, 254}, .scale = 92}; };

    Sketch whole(svg, view(110));
    draw_polygons(whole, polygons);
    draw_box(whole, hierarchy.bounds(), {.color = blue, .width = 2});
    Sketch parts(svg, view(322));
    draw_polygons(parts, polygons);
    for (const BoundingBox& box : first_boxes(hierarchy, boxes))
        draw_box(parts, box, {.color = blue, .width = Real(1.5)});

    Sketch asked(svg, view(534));
    draw_polygons(asked, polygons);
    const Ray ray{.origin = {-1.12, 0.3, 1.5}, .direction = {1, 0.75, -0.6}};
    RayBoxTestCache slabs(ray);
    Interval interval;
    std::set<std::uint32_t> entered;
    hierarchy.nearest(slabs, interval, [&](std::uint32_t index) {
        entered.insert(index);
        const Polygon& polygon = polygons[index];
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            const Mesh one{.vertices = {polygon[0], polygon[i - 1], polygon[i]},
                           .triangles = {{0, 1, 2}}};
            if (const auto hit = intersect(ray, one, interval)) interval.max = hit->t;
        }
    });
    for (const std::uint32_t index : entered)
        draw_box(asked, boxes[index], {.color = red, .width = Real(1.2)});
    asked.ray(ray, interval.max);
    asked.mark(at(ray, interval.max), Mark::hit);

    const TextStyle note{.size = 13};
    svg.text({110, 284}, "one box around a coarse owl", note);
    svg.text({322, 284}, "around its parts, eight boxes", note);
    svg.text({534, 284},
             "a ray tests " + std::to_string(entered.size()) + " of its " +
                 std::to_string(polygons.size()) + " polygons",
             note);
    return svg.source();
}

}  // namespace rt::figures

#include "common/program/requirements.hpp"

#include "common/render/render_settings.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"
#include "common/tuning/choices.hpp"
#include "common/tuning/input_rounding.hpp"
#include "common/tuning/render_trials.hpp"

#include <algorithm>

namespace rt {

namespace {

bool has_many(const Scene& scene) {
    bool many = false;
    for_each_kind(scene, [&many](const auto& primitives) { many = many || primitives.many(); });
    return many;
}

/// The depth from which on reflections are too weak to be seen. A lone mirror that cannot reflect
/// itself needs one.
int depth_of_mirrors(const Scene& scene) {
    double strongest = 0;
    int mirrors = 0;
    for_each_material(scene, [&](const Material& material) {
        strongest = std::max(strongest, double(material.mirror));
        mirrors += material.mirror > 0 ? 1 : 0;
    });
    const bool hollow = !scene.cylinders.empty() || !scene.cones.empty();
    if (mirrors < 2 && !hollow && scene.mesh_requests.empty()) return 1;
    constexpr double visible = 8;  // of whose tolerance the omitted reflections use one level
    return sufficient_depth(strongest, visible);
}

std::string padded(const std::string& text, std::size_t width) {
    const std::size_t columns = columns_of(text);
    return text + std::string(columns < width ? width - columns : 1, ' ');
}

}  // namespace

std::vector<Advice> advice(const Scene& scene) {
    const int depth = depth_of_mirrors(scene);
    const SceneLengths lengths = scene_lengths(scene);
    std::vector<Advice> rows;
    const auto add = [&rows](bool applies, const Advice& row) {
        if (applies) rows.push_back(row);
    };
    const bool has_sized =
        std::ranges::any_of(scene.lights, [](const Light& light) { return light.radius > 0; });
    add(true, {"edges", "steps", "--pixel-error 8", "4 to 8 times the time"});
    add(has_sized, {"a lamp with a size", "grain", "--shadow-samples 64", "4 times its rays"});
    add(depth > RenderSettings().depth, {"mirrors", "reflections end too early",
                                         "--depth " + std::to_string(depth), "hardly any time"});
    add(fine_shapes(scene).matter(),
        {"narrow shapes", "gaps, missing parts", "--tolerance 2", "the rays they need"});
    add(lengths.loses_sizes(float_unit_roundoff),
        {"far from the origin", "float is off", "--precision double", "up to 1.1 times"});
    add(lengths.gap == 0,
        {"surfaces in one place", "speckles", "--precision exact", "1.2 to 2.1 times"});
    add(has_many(scene), {"many shapes", "nothing", "a hierarchy is built", "less time"});
    add(!scene.mesh_requests.empty(),
        {"a mesh", "its edges", "all of its triangles", "1 % of the time"});
    return rows;
}

std::string explanation(const Scene& scene) {
    const std::vector<Requirement> needs = requirements(scene);
    const auto brought_by = [&needs](int stage) {
        return std::ranges::any_of(
            needs, [stage](const Requirement& need) { return need.stage == stage; });
    };
    std::string lines = tr(" requires") + "\n";
    for (const auto& [what, stage] : needs)
        lines += "  " + padded(tr_text(what), 28) + name_of(stage) + "\n";
    if (needs.empty()) lines += "  " + tr("only rays") + "\n";

    lines += tr("and does not use") + "\n";
    const auto without = [&lines](bool left_out, const std::string& what) {
        if (left_out) lines += "  " + tr(what) + "\n";
    };
    for (int stage = shapes_stage; stage < light_stage; ++stage)
        without(!brought_by(stage), topic_of(stage) + "s");
    without(!brought_by(mesh_stage), "boxes and meshes");
    without(scene.lights.empty(), "light other than ambient, and shadow rays");
    without(!brought_by(soft_shadow_stage), "several rays for a shadow: no light has a size");
    without(!brought_by(mirror_stage), "reflections: there is no mirror");
    without(!has_many(scene) && scene.mesh_requests.empty(),
            "a hierarchy of boxes: so few shapes are faster without");
    const auto row = [&lines](const std::string& wrong, const std::string& mends,
                              const std::string& costs) {
        lines += padded(wrong, 37) + padded(mends, 22) + costs + "\n";
    };
    row(tr("and is wrong first in"), tr("mended by"), tr("at the cost of"));
    for (const auto& [seen, wrong, mends, costs] : advice(scene))
        row("  " + tr(seen) + tr(": ") + tr(wrong), tr(mends), tr(costs));
    return lines;
}

}  // namespace rt

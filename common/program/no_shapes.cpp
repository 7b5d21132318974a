// In the programs of the stages before there are shapes, in place of hierarchies and the choice of
// settings: nothing calls these functions, and a hierarchy that is empty is not used.
#include "common/bvh/bvh.hpp"
#include "common/bvh/mesh_bvh.hpp"
#include "common/tuning/auto_settings.hpp"
#include "common/tuning/render_trials.hpp"

namespace rt {

Bvh::Bvh(std::size_t /*count*/, const BoxOf& /*box*/, Leaves /*leaves*/,
         const BoundingBox& /*scene*/) {}

MeshBvh::MeshBvh(const Mesh& /*mesh*/) {}

SceneTraits scene_traits(const Scene& /*scene*/, int /*stage*/, const RenderSettings& /*used*/) {
    return {};
}

TrialSample render_pixels(const Scene& /*scene*/, const RenderSettings& /*settings*/,
                          const TrialRequest& /*request*/) {
    return {};
}

TrialHistories trace_histories(const Scene& /*scene*/, const RenderSettings& /*settings*/,
                               const TrialRequest& /*request*/) {
    return {};
}

#ifndef RT_FLOAT  // once
std::optional<AutoSettings> choose(Trials& /*trials*/, const OpenFloat& /*open_float*/,
                                   const Aim& /*aim*/, Clock::time_point /*start*/,
                                   const std::atomic<bool>& /*stop*/) {
    return std::nullopt;
}

RenderSettings TimeBudget::next(Clock::time_point /*now*/) {
    return {};
}

bool stops_sampling(const Trials& /*trials*/, const RenderSettings& /*settings*/) {
    return true;
}
#endif

}  // namespace rt

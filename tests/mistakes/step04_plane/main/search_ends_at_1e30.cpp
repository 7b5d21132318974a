// origin: invented: 1e30 for infinity
// caught by: each kind of shape hides what is farther away, in any order of the file (CR §2.1)
// sentence: You ignore hits beyond a constant. A hit may be at any distance: an Interval ends at infinity.
#include "common/render/closest_hit.hpp"

namespace rt {

struct ClosestHitUntil1e30 : ClosestHit {
    using ClosestHit::ClosestHit;

    [[nodiscard]] std::optional<Hit> hit() const {
        const std::optional<Hit> any = ClosestHit::hit();
        return any && any->t <= Real(1e30) ? any : std::nullopt;
    }
};

}  // namespace rt

#define ClosestHit ClosestHitUntil1e30
#include "steps/step04_plane/main.cpp"

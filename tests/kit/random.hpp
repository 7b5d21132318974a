// Random numbers that make failures repeatable and reducible.
#pragma once

#include "common/math/basis.hpp"
#include "common/math/real.hpp"

#include <cstdint>
#include <random>
#include <vector>

namespace rt {

/// Generates numbers, and records the choices that made them: replayed, they make the same case. A
/// choice of ½ always makes the plainest value, so that simpler choices are simpler cases.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// Draws these choices again; ½ once they are used up.
    explicit Random(std::vector<double> choices) : choices_(std::move(choices)), replays_(true) {}

    /// The raw material: 0 to 1.
    double choice();

    Real between(Real low, Real high);
    /// 2^k, −10 ≤ k ≤ 10: scaling by it rounds nothing.
    Real power_of_two();
    /// Multiples of 1/8: sums and products of a few of them are not rounded.
    Real eighths(int low, int high);
    bool coin();
    int below(int count);    ///< 0 to count − 1
    Vec3 point(Real reach);  ///< each coordinate from −reach to reach
    Vec3 point_in_eighths(int reach);
    Vec3 direction();  ///< unit length, any direction
    Basis basis();     ///< any rotation
    Basis axes();      ///< one of the 24 rotations that map axes to axes

    [[nodiscard]] const std::vector<double>& choices() const { return choices_; }

private:
    std::mt19937_64 engine_;
    std::vector<double> choices_;
    bool replays_ = false;
    std::size_t next_ = 0;
};

}  // namespace rt

// Roots of polynomials with exact coefficients, compared without working them out.
#pragma once

#include "tests/oracle/exact.hpp"

#include <vector>

namespace rt::oracle {

/// (rational + surd √radicand) / denominator: a ray's t for a plane or a quadric.
class Root {
public:
    /// numerator / denominator, which is not 0.
    Root(const Exact& numerator, const Exact& denominator);
    Root(const Exact& rational, const Exact& surd, const Exact& radicand, const Exact& denominator);

    /// The sign of c0 + c1 t + c2 t² at this t: exact, like all functions of a root.
    [[nodiscard]] int sign_of(const Exact& c0, const Exact& c1, const Exact& c2 = 0) const;

    [[nodiscard]] Number value() const;

private:
    Exact rational_;
    Exact surd_;
    Exact radicand_;
    Exact denominator_;  ///< positive
};

/// The real t with a t² + 2 b t + c = 0, in ascending order; one for a double root, and none if all
/// coefficients are 0.
[[nodiscard]] std::vector<Root> quadratic_roots(Exact a, Exact b, Exact c);

}  // namespace rt::oracle

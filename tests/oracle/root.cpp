#include "tests/oracle/root.hpp"

namespace rt::oracle {

namespace {

/// The sign of p + q √d: if the signs of the terms differ, the larger square decides.
int sign_of_sum(const Exact& p, const Exact& q, const Exact& d) {
    const int surd = q.sign() * d.sign();
    if (p.sign() * surd >= 0) return p.sign() != 0 ? p.sign() : surd;
    return p.sign() * (squared(p) - squared(q) * d).sign();
}

}  // namespace

Root::Root(const Exact& numerator, const Exact& denominator) : Root(numerator, 0, 0, denominator) {}

Root::Root(const Exact& rational, const Exact& surd, const Exact& radicand,
           const Exact& denominator)
    : rational_(rational), surd_(surd), radicand_(radicand), denominator_(denominator) {
    if (denominator_.sign() > 0) return;
    rational_ = -rational_;
    surd_ = -surd_;
    denominator_ = -denominator_;
}

int Root::sign_of(const Exact& c0, const Exact& c1, const Exact& c2) const {
    const Exact& n = denominator_;
    if (c2.sign() == 0) return sign_of_sum(c0 * n + c1 * rational_, c1 * surd_, radicand_);
    const Exact square = squared(rational_) + squared(surd_) * radicand_;
    const Exact rational = c0 * squared(n) + c1 * n * rational_ + c2 * square;
    const Exact surd = c1 * n * surd_ + 2 * c2 * rational_ * surd_;
    return sign_of_sum(rational, surd, radicand_);
}

Number Root::value() const {
    const Number p = rational_.number();
    if (surd_.sign() == 0 || radicand_.sign() == 0) return p / denominator_.number();
    const Number root = surd_.number() * sqrt(radicand_.number());
    if (rational_.sign() * surd_.sign() >= 0) return (p + root) / denominator_.number();
    // p + q √d = (p² − q² d) / (p − q √d), without cancellation.
    const Exact product = squared(rational_) - squared(surd_) * radicand_;
    return product.number() / (p - root) / denominator_.number();
}

std::vector<Root> quadratic_roots(Exact a, Exact b, Exact c) {
    if (a.sign() == 0) {
        if (b.sign() == 0) return {};
        return {Root(-c, 2 * b)};
    }
    if (a.sign() < 0) {
        a = -a;
        b = -b;
        c = -c;
    }
    const Exact quarter = squared(b) - a * c;
    if (quarter.sign() < 0) return {};
    if (quarter.sign() == 0) return {Root(-b, a)};
    return {Root(-b, -1, quarter, a), Root(-b, 1, quarter, a)};
}

}  // namespace rt::oracle

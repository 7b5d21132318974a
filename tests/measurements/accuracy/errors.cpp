// The errors of each form, against exact arithmetic (docs/reference/stability.md): over all sweeps,
// and decade by decade along one growing quantity.
//
// For each sweep: the number of wrong decisions; the distance of o + t d from the surface in a
// typical hit, and in all but one hit in a thousand, relative to the largest coordinate.
#include "tests/measurements/accuracy/forms.hpp"
#include "tests/stability/judge.hpp"

#include "common/geometry/transform.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace rt;

namespace {

constexpr int rays_of_a_sweep = 4000;
constexpr int rays_of_a_decade = 2000;

/// The result of one form.
struct Tally {
    int rays = 0;
    int wrong = 0;
    std::vector<double> off;

    void add(const Judgment& judgment) {
        ++rays;
        wrong += judgment.wrong;
        if (judgment.off) off.push_back(*judgment.off * double(unit_roundoff));
    }

    /// The error that this share of the hits has at most.
    [[nodiscard]] double largest_of(double share) {
        if (off.empty()) return 0;
        const auto last = std::ptrdiff_t(share * double(off.size() - 1));
        std::ranges::nth_element(off, off.begin() + last);
        return off[std::size_t(last)];
    }
};

/// Puts the same cases to all forms of a shape.
template <class Shape>
class Panel {
public:
    explicit Panel(const Shape& shape) : forms_(forms_of(shape)), tallies_(forms_.size()) {}

    void ask(const Case<Shape>& asked) {
        // Forms often agree to the last digit, and the exact comparison takes most of the time.
        std::vector<std::pair<std::optional<Real>, Judgment>> known;
        for (std::size_t i = 0; i < forms_.size(); ++i) {
            const auto got = forms_[i].intersect(asked.ray, asked.shape, {});
            auto same = std::ranges::find_if(known, [&](auto& k) { return k.first == got; });
            if (same == known.end()) same = known.insert(known.end(), {got, judged(asked, got)});
            tallies_[i].add(same->second);
        }
    }

    void print(const char* shape, const char* axis, double at) {
        for (std::size_t i = 0; i < forms_.size(); ++i) {
            Tally& tally = tallies_[i];
            std::printf("%s,%s,%s,%s,%g,%d,%d,%.3g,%.3g\n", shape, forms_[i].name,
                        forms_[i].precision, axis, at, tally.rays, tally.wrong,
                        tally.largest_of(0.5), tally.largest_of(0.999));
        }
        std::fflush(stdout);
    }

private:
    std::vector<Form<Shape>> forms_;
    std::vector<Tally> tallies_;
};

/// An ordinary ray, from so far away.
template <class Shape>
Case<Shape> from_afar(Random& random, Real distance) {
    Case<Shape> asked;
    draw(random, Sweep::moderate, asked);
    asked.ray.origin -= distance * unit(asked.ray.direction);
    return asked;
}

/// An ordinary ray, with everything moved by this distance.
template <class Shape>
Case<Shape> moved_away(Random& random, Real distance) {
    Case<Shape> asked;
    draw(random, Sweep::moderate, asked);
    const Transform transform{.translation = distance * random.direction()};
    return {.ray = {.origin = transformed(asked.ray.origin, transform),
                    .direction = asked.ray.direction},
            .shape = transformed(asked.shape, transform)};
}

template <class Shape>
void measure_sweeps(const char* name, const Shape& shape) {
    Panel<Shape> panel(shape);
    Random random(1);
    for (int sweep = 0; sweep <= int(Sweep::sliver); ++sweep)
        for (int i = 0; i < rays_of_a_sweep; ++i) {
            Case<Shape> asked;
            draw(random, Sweep(sweep), asked);
            panel.ask(asked);
        }
    panel.print(name, "all", 0);
}

template <class Shape>
void measure_decades(const char* name, const Shape& shape) {
    Random random(2);
    struct Axis {
        const char* name;
        Case<Shape> (*sample)(Random& random, Real distance);
    };
    for (const Axis& axis : {Axis{"distance", from_afar<Shape>}, Axis{"offset", moved_away<Shape>}})
        for (int decade = 0; decade <= 8; ++decade) {
            const Real distance = std::pow(Real(10), Real(decade));
            Panel<Shape> panel(shape);
            for (int i = 0; i < rays_of_a_decade; ++i) panel.ask(axis.sample(random, distance));
            panel.print(name, axis.name, double(distance));
        }
}

/// Rays past a silhouette or along a face, each in the decade that it was drawn in.
template <class Shape>
void measure_grazing(const char* name, const Shape& shape) {
    Random random(3);
    constexpr int first = sizeof(Real) == 8 ? -18 : -12;  // the sweep's extent
    constexpr int decades = -1 - first;
    std::vector<Panel<Shape>> panels(decades, Panel<Shape>(shape));
    for (int i = 0; i < decades * rays_of_a_decade; ++i) {
        Case<Shape> asked;
        const Real beside = draw(random, Sweep::grazing, asked);
        const int decade = int(std::floor(std::log10(beside))) - first;
        if (0 <= decade && decade < decades) panels[std::size_t(decade)].ask(asked);
    }
    for (int decade = 0; decade < decades; ++decade)
        panels[std::size_t(decade)].print(name, "grazing", std::pow(10.0, first + decade));
}

}  // namespace

int main() {
    std::puts("shape,form,precision,axis,at,rays,wrong,median,most");
    for_every_shape([](const char* name, const auto& shape) {
        measure_sweeps(name, shape);
        measure_decades(name, shape);
        measure_grazing(name, shape);
    });
}

// Questions to a stage, answered in sentences: CHECK(hits(ray, sphere, 4)).
#pragma once

#include "tests/kit/catch.hpp"
#include "tests/kit/report.hpp"

#include "common/explain/text.hpp"
#include "common/geometry/ray.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

namespace rt {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// The tolerance of suites, relative to the exact answer: examples and random cases stay within ten
/// sizes of a shape and 0.2 of grazing. There the textbook's formulas lose at most (10²) / 0.2 =
/// 500 epsilon, with a few operations each. A larger error is a wrong answer.
constexpr Real tolerance = 4096 * epsilon;

/// The result of a check, and the message for the student if it failed.
struct Verdict {
    bool holds = true;
    std::string sentence = {};

    explicit operator bool() const { return holds; }
};

/// The text itself, or the text that the function returns: of thousands of random calls, only a
/// failing one needs its text.
template <class Text>
std::string written(const Text& sentence) {
    if constexpr (std::is_invocable_v<Text>)
        return sentence();
    else
        return sentence;
}

/// Passes, or fails with a sentence, which is a text or a function that returns one.
template <class Sentence>
Verdict verdict(bool holds, const Sentence& sentence) {
    if (holds) return {};
    Verdict failed{.holds = false, .sentence = written(sentence)};
    failures_of_case.add(failed.sentence);
    return failed;
}

/// Keeps the first failed verdict. A test that evaluates all its questions uses it instead of
/// returning at the first failure, because a known mistake of `trace` is recognized by the complete
/// set of questions that it fails.
inline void keep_first(Verdict& kept, Verdict next) {
    if (kept.holds) kept = std::move(next);
}

inline bool close(Real got, Real expected, Real scale = 1) {
    return std::abs(got - expected) <= tolerance * std::max(std::abs(expected), scale);
}

inline bool close(Vec2 got, Vec2 expected) {
    return close(got.x, expected.x) && close(got.y, expected.y);
}

inline bool close(Vec3 got, Vec3 expected) {
    const Vec3 size = abs(expected);
    const Real scale = std::max({size.x, size.y, size.z, Real(1)});
    return close(got.x, expected.x, scale) && close(got.y, expected.y, scale) &&
           close(got.z, expected.z, scale);
}

inline std::string got_text(std::optional<Real> t) {
    return t ? "a hit at t = " + text(*t) : "no hit";
}

/// The lines of a failure: the call, the answer, the expected answer, and a line to paste into a
/// test.
template <class Shape>
std::string intersection_report(const Ray& ray, const Shape& shape, Interval interval,
                                std::optional<Real> got, std::optional<Real> expected) {
    const bool whole = interval.min == 0 && interval.max == infinity;
    const std::string question =
        code(ray) + ",\n          " + code(shape) + (whole ? "" : ",\n          " + code(interval));
    const std::string paste = expected ? "hits(" + code(ray) + ", " + code(shape) + ", " +
                                             code(*expected) + (whole ? "" : ", " + code(interval))
                                       : "misses(" + code(ray) + ", " + code(shape) +
                                             (whole ? "" : ", " + code(interval));
    return "intersect(" + question + ")\n  got:      " + got_text(got) +
           "\n  expected: " + got_text(expected) + "\n  paste:    CHECK(" + paste + "));";
}

/// The ray's first hit inside the interval is at t.
template <class Shape>
Verdict hits(const Ray& ray, const Shape& shape, Real t, Interval interval = {}) {
    const std::optional<Real> got = intersect(ray, shape, interval);
    return verdict(got && close(*got, t, 0),
                   [&] { return intersection_report(ray, shape, interval, got, t); });
}

/// The ray has no hit inside the interval.
template <class Shape>
Verdict misses(const Ray& ray, const Shape& shape, Interval interval = {}) {
    const std::optional<Real> got = intersect(ray, shape, interval);
    return verdict(!got,
                   [&] { return intersection_report(ray, shape, interval, got, std::nullopt); });
}

/// A value that should equal the expected one; `what` is the call that returned it, a text or a
/// function that returns one.
template <class What, class Value>
Verdict gives(const What& what, Value got, Value expected) {
    return verdict(close(got, expected), [&] {
        return written(what) + "\n  got:      " + text(got) + "\n  expected: " + text(expected);
    });
}

/// normal(shape, point) is unit length and points where it should.
template <class Shape>
Verdict normal_is(const Shape& shape, Vec3 point, Vec3 expected) {
    return gives([&] { return "normal(" + code(shape) + ", " + code(point) + ")"; },
                 normal(shape, point), expected);
}

}  // namespace rt

namespace Catch {

template <>
struct StringMaker<rt::Verdict> {
    static std::string convert(const rt::Verdict& verdict) { return "\n  " + verdict.sentence; }
};

}  // namespace Catch

// The body of a contract's function that sends its call to a worker.
#pragma once

#include "common/contract/contracts.hpp"

#include "tests/contract/change.hpp"

namespace rt::contract {

/// The worker's answer to a question, both as bytes. Throws NoAnswer.
[[nodiscard]] std::string answer_of_worker(const std::string& question);

/// return ask<3, "intersect">(ray, sphere, interval);
template <int Stage, Word Name, class... Arguments>
auto ask(const Arguments&... arguments) {
    using Functions = typename Contract<Stage>::Functions;
    constexpr std::size_t place = find_function<Functions, Name, Arguments...>();
    Writer question;
    put(question, Number{.stage = Stage, .place = std::uint8_t(place)});
    (put(question, arguments), ...);
    const std::string bytes = answer_of_worker(question.bytes());
    Reader reader(bytes);
    auto answer = get<typename std::tuple_element_t<place, Functions>::Answer>(reader);
    reader.end();
    return answer;
}

/// intersect, after the case's change.
template <int Stage, class Shape>
std::optional<Real> ask_hit(const Ray& ray, const Shape& shape, Interval interval) {
    const Change* const now = change();
    if (now == nullptr) return ask<Stage, "intersect">(ray, shape, interval);
    const std::optional<Real> t =
        ask<Stage, "intersect">(transformed(ray, now->any, now->length),
                                rt::transformed(shape, now->any), divided(interval, now->length));
    return t ? *t * now->length : t;
}

/// normal, after the case's change.
template <int Stage, class Shape>
Vec3 ask_normal(const Shape& shape, Vec3 point) {
    const Change* const now = change();
    if (now == nullptr) return ask<Stage, "normal">(shape, point);
    return turned_back(
        ask<Stage, "normal">(rt::transformed(shape, now->any), rt::transformed(point, now->any)),
        now->any);
}

/// The coordinates of a point in a shape, such as barycentric ones, after the case's change.
template <int Stage, Word Name, class Shape>
auto ask_place(const Shape& shape, Vec3 point) {
    const Change* const now = change();
    if (now == nullptr) return ask<Stage, Name>(shape, point);
    return ask<Stage, Name>(rt::transformed(shape, now->any), rt::transformed(point, now->any));
}

/// The color of a surface in a light, after the case's change.
template <int Stage, Word Name, class AnyLight>
Color ask_color(const ShadingPoint& surface, const AnyLight& light) {
    const Change* const now = change();
    if (now == nullptr) return ask<Stage, Name>(surface, light);
    return exchanged_back(
               ask<Stage, Name>(changed(surface, *now, now->any), changed(light, *now, now->any)),
               *now) /
           now->light;
}

}  // namespace rt::contract

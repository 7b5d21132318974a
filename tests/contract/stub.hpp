// The body of a contract's function where it is asked of a worker.
#pragma once

#include "tests/contract/contracts.hpp"

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

}  // namespace rt::contract

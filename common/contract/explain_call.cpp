// explain_call STAGE CALL WORKER
//
// Explains a call that a suite has reported, for `./course explain`: the quantities of the
// documents for an intersection, and the result of the worker's function. Exit status 2 if it is no
// call of the stage.
#include "common/contract/call.hpp"
#include "common/explain/pixel_log.hpp"
#include "common/scene/scene.hpp"

#include <iostream>
#include <stdexcept>

namespace rt::contract {

namespace {

std::optional<Real> t_of(const Answer& answer) {
    if (!answer.value || answer.value->parts.empty()) return std::nullopt;
    return Real(answer.value->parts[0].number);
}

/// The same call without an end of the interval.
Call without_end(Call call) {
    for (Value& argument : call.arguments)
        if (argument.type == &type_of<Interval>()) argument.parts[1].number = double(infinity);
    return call;
}

/// Logs an intersection with a shape. Returns false for any other call.
bool explain_intersection(PixelLog& log, const Call& call, const Answer& answer, Asked& worker) {
    if (call.callee->answer != &type_of<std::optional<Real>>() || call.arguments.size() != 3)
        return false;
    const auto ray = as<Ray>(call.arguments[0]);
    const auto interval = as<Interval>(call.arguments[2]);
    if (!ray || !interval) return false;
    bool is_explained = false;
    const auto look_for = [&]<class Shape>(const ShapeKind<Shape>& /*kind*/) {
        const auto shape = as<Shape>(call.arguments[1]);
        if (!shape) return;
        explain_candidate(log, *ray, *shape, *interval, t_of(answer),
                          [&] { return t_of(worker(without_end(call))); });
        is_explained = true;
    };
    std::apply([&](const auto&... kind) { (look_for(kind), ...); }, shape_kinds);
    return is_explained;
}

void explain(int stage, const std::string& text, const std::string& program) {
    const auto found = call_of_suite(stage, text);
    if (!found) throw Malformed("no call of the stage: " + text);
    const Call& call = *found;
    Asked worker(program);
    const Answer answer = worker(call);
    PixelLog log(std::cout);
    log.heading("The call that fails");
    log.line("call", code(call));
    if (!explain_intersection(log, call, answer, worker) || !answer.value)
        log.line("result", answer.value ? code(answer) : answer.failure);
}

}  // namespace

}  // namespace rt::contract

int main(int argc, char** argv) {
    try {
        if (argc != 4) throw std::runtime_error("explain_call STAGE CALL WORKER");
        rt::contract::explain(std::stoi(argv[1]), argv[2], argv[3]);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
}

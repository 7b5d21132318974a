// Calls of a contract's functions, and a worker's answers.
#pragma once

#include "common/contract/asking.hpp"
#include "common/contract/value.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rt::contract {

/// A function of a contract, as seen by a client.
struct Callee {
    int stage;
    int place;
    std::string name;
    std::vector<const Type*> parameters;
    const Type* answer;
};

[[nodiscard]] const std::vector<Callee>& callees();

struct Call {
    const Callee* callee = nullptr;
    std::vector<Value> arguments;
};

/// The bytes of a question, as suites record them.
[[nodiscard]] std::string question_of(const Call& call);
[[nodiscard]] Call call_of(std::string_view question);

/// "intersect(Ray{…}, Sphere{…}, Interval{…})"
[[nodiscard]] std::string code(const Call& call);
/// The call of a stage that code has written. Throws Malformed.
[[nodiscard]] Call read_call(int stage, std::string_view text);

/// An answer, or the reason why there is none: "crashed: Segmentation fault".
struct Answer {
    std::optional<Value> value;
    std::string failure = {};

    /// False if the query was not sent, after too many crashes: then the answer means nothing.
    [[nodiscard]] bool asked() const { return !failure.starts_with("was not run"); }
};

[[nodiscard]] std::string code(const Answer& answer);
[[nodiscard]] Answer read_answer(const Callee& callee, std::string_view text);
/// Failures are equal if they start with the same word: it crashed, it gave no answer.
[[nodiscard]] bool same(const Answer& got, const Answer& expected, double within);

/// A worker process, restarted after a crash up to a limit.
class Asked {
public:
    explicit Asked(std::string program, int crashes = 8)
        : program_(std::move(program)), left_(crashes) {}

    [[nodiscard]] Answer operator()(const Call& call);
    [[nodiscard]] std::vector<Answer> operator()(const std::vector<Call>& calls);

private:
    std::string program_;
    std::unique_ptr<Worker> worker_;
    double used_ = 0;   ///< by the workers that ended
    int left_;          ///< number of crashes still allowed
    std::string gone_;  ///< the reason why no more queries are sent
};

// The parts of a call's arguments, with their names.

/// Calls visit(part, its name) for a value and all of its parts.
template <class Visit>
void for_each_within(Value& value, const std::string& name, Visit& visit) {
    visit(value, name);
    for (std::size_t i = 0; i < value.parts.size(); ++i) {
        const bool named = value.type->kind == Type::Kind::record;
        for_each_within(value.parts[i], named ? value.type->parts[i].name : name, visit);
    }
}

template <class Visit>
void for_each_within(Call& call, Visit visit) {
    for (Value& argument : call.arguments) for_each_within(argument, "", visit);
}

/// True for the name of a point, false for a direction's.
[[nodiscard]] bool is_place(const std::string& name);

[[nodiscard]] bool is_basis(const Value& value);

/// The call of the stage that a suite has printed, without an interval that has no end; nothing if
/// it is none.
[[nodiscard]] std::optional<Call> call_of_suite(int stage, std::string text);

/// The calls of the stage's functions with which failures begin in the output of
/// tests/kit/report.cpp, in its order. Other questions, of several calls say, are left out.
[[nodiscard]] std::vector<Call> failing_calls(int stage, const std::string& report);

}  // namespace rt::contract

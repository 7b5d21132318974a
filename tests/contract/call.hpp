// Calls of a contract's functions, and what a worker answers.
#pragma once

#include "tests/contract/asking.hpp"
#include "tests/contract/value.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rt::contract {

/// A function of a contract, seen from outside.
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

/// An answer, or why there was none: "crashed: Segmentation fault".
struct Answer {
    std::optional<Value> value;
    std::string failure = {};

    /// False once too much has been lost to ask again: then it says nothing about the call.
    [[nodiscard]] bool asked() const { return !failure.starts_with("was not asked"); }
};

[[nodiscard]] std::string code(const Answer& answer);
[[nodiscard]] Answer read_answer(const Callee& callee, std::string_view text);
/// Failures are the same if they begin with the same word: it crashed, it gave no answer.
[[nodiscard]] bool same(const Answer& came, const Answer& expected, double within);

/// Somebody who is asked: a worker, and another one when it is gone, but not for ever.
class Asked {
public:
    explicit Asked(std::string program) : program_(std::move(program)) {}

    [[nodiscard]] Answer operator()(const Call& call);
    [[nodiscard]] std::vector<Answer> operator()(const std::vector<Call>& calls);

private:
    std::string program_;
    std::unique_ptr<Worker> worker_;
    double used_ = 0;   ///< by those that are gone
    int left_ = 8;      ///< how many may still crash
    std::string gone_;  ///< why no more are asked
};

}  // namespace rt::contract

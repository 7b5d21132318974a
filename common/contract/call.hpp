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

}  // namespace rt::contract

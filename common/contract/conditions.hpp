// The conditions of a contract that a plainer call must keep.
#pragma once

#include "common/contract/call.hpp"

namespace rt::contract {

/// Unit lengths stay unit, positive numbers stay positive, and shares stay between 0 and 1, as in
/// the call from which the search starts.
class Conditions {
public:
    explicit Conditions(Call call) : start_(std::move(call)) {}

    [[nodiscard]] bool hold(Call call) const;

private:
    Call start_;
};

/// True if a call's arguments are independent. The point of a normal is on the shape, and the point
/// of a weight is in the triangle's plane: those must change together.
[[nodiscard]] bool is_free(const Callee& callee);

}  // namespace rt::contract

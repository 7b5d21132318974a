// What a stage's program does once it knows what is asked for.
#pragma once

#include "common/real.hpp"
#include "common/session.hpp"

#include <memory>

namespace rt::inline RT_PRECISION {

/// Reads the scene. Throws InputError for what is wrong with it.
[[nodiscard]] std::unique_ptr<Session> open_session(const Program& program, const Options& options);

}  // namespace rt::inline RT_PRECISION

// The engine of the book's figures: every function of every contract behind one C function that
// carries the bytes of common/contract.
#pragma once

#include <cstddef>

extern "C" {

/// Room for a question of this size.
char* engine_room(std::size_t size);

/// Answers the question in the room. Returns the size of the answer, 0 if there is no such
/// function.
std::size_t engine_ask(std::size_t size);

/// Makes the list of functions the result, as JSON (describe.hpp). Returns its size.
std::size_t engine_describe();

/// The last answer or list.
const char* engine_result();
}

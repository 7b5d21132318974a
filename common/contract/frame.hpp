// Queries and answers on a socket. Both consist of the size of the payload, a ticket, and the
// payload. An answer carries its query's ticket, which cannot be known before the query is sent.
#pragma once

#include <cstdint>

namespace rt::contract {

struct Frame {
    std::uint64_t size;
    std::uint64_t ticket;
};

/// A larger query is refused: a mesh of a million triangles has 60 MB.
inline constexpr std::uint64_t largest_question = std::uint64_t(256) << 20;

/// A larger answer is refused: a picture of 640 × 480 pixels has 0.9 MB, 65536 points of a light
/// 1.5 MB, and any other answer only some numbers.
inline constexpr std::uint64_t largest_answer = std::uint64_t(4) << 20;

/// The sent part of an exception's message.
inline constexpr std::size_t longest_words = 200;

/// The first byte of an answer.
enum class Outcome : std::uint8_t {
    answered,  ///< the answer's bytes follow
    thrown,    ///< followed by the exception's message
};

/// The worker's descriptor for queries and answers.
inline constexpr int worker_descriptor = 3;

/// The exit status of a worker after a malformed query.
inline constexpr int malformed_status = 65;

}  // namespace rt::contract

// Questions and answers on a socket. Either way: the size of what follows, a ticket, and that. An
// answer has its question's ticket, which nobody can know before the question is asked.
#pragma once

#include <cstdint>

namespace rt::contract {

struct Frame {
    std::uint64_t size;
    std::uint64_t ticket;
};

/// A question that says it is larger is refused: a mesh of a million triangles has 60 MB.
inline constexpr std::uint64_t largest_question = std::uint64_t(256) << 20;

/// An answer that says it is larger is refused: a picture of 640 × 480 pixels has 0.9 MB, 65536
/// points of a light 1.5 MB, and anything else some numbers.
inline constexpr std::uint64_t largest_answer = std::uint64_t(4) << 20;

/// Of the words of an exception, what is sent.
inline constexpr std::size_t longest_words = 200;

/// The first byte of an answer.
enum class Outcome : std::uint8_t {
    answered,  ///< the answer's bytes follow
    thrown,    ///< the words of an exception follow
};

/// Where a worker is asked, and answers.
inline constexpr int worker_descriptor = 3;

/// The exit status of a worker that was asked what is no question.
inline constexpr int malformed_status = 65;

}  // namespace rt::contract

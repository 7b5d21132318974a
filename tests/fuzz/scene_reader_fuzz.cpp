// libFuzzer's entry into the scene reader, in both precisions. docs/scenes.md explains how to run
// it.

#include "tests/fuzz/scene_invariants.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // char may alias any object's bytes.
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    rt::f32::check_invariants(text);
    rt::f64::check_invariants(text);
    return 0;
}

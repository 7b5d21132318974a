// The engine without WebAssembly: questions on the standard input, answers on the output, each
// after its size. An answer has the same bytes as in a page.
#include "docs/figures/engine/engine.hpp"

#include <cstdint>
#include <cstdio>

int main() {
    std::uint32_t size = 0;
    while (std::fread(&size, sizeof size, 1, stdin) == 1) {
        if (std::fread(engine_room(size), 1, size, stdin) != size) return 1;
        size = std::uint32_t(engine_ask(size));
        std::fwrite(&size, sizeof size, 1, stdout);
        std::fwrite(engine_result(), 1, size, stdout);
    }
}

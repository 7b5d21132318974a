// `./course view` on folders of a test's own: view_server PROJECT BUILD STAGE. A file
// PROJECT/compiler_says replaces a compiler.
#include "common/course/view/view.hpp"

#include "common/system/input_error.hpp"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const std::filesystem::path project = argv[1];
    try {
        return rt::view({.project = project,
                         .build = argv[2],
                         .stage = std::atoi(argv[3]),
                         .render_limit = std::chrono::seconds(20),
                         .rebuild = [&](int) {
                             std::ifstream said(project / "compiler_says");
                             return std::string(std::istreambuf_iterator<char>(said), {});
                         }});
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}

#include "common/scene_reader.hpp"

#include "tests/corpus/outcome.hpp"

namespace rt {

Outcome RT_PRECISION::read_outcome(const std::string& file, bool strict) {
    try {
        static_cast<void>(load_scene(file, {.strict = strict}));
        return {.accepted = true, .message = ""};
    } catch (const InputError& error) {
        return {.accepted = false, .message = error.what()};
    }
}

}  // namespace rt

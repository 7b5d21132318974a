#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/programs/corpus/outcome.hpp"

namespace rt {

Outcome RT_PRECISION::read_outcome(const std::string& file, bool strict) {
    try {
        static_cast<void>(load_scene(file, orthonormal_basis, {.strict = strict}));
        return {.accepted = true, .message = ""};
    } catch (const InputError& error) {
        return {.accepted = false, .message = error.what()};
    }
}

}  // namespace rt

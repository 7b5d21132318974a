// Compiled for each stage, by which its program differs from the others.
namespace rt {

extern const int stage_number;  // options.hpp
const int stage_number = RAYSTEPS_STAGE;

}  // namespace rt

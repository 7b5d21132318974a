// Any bytes as an object file of a submission: they are refused, or its symbols are named.
#include "common/course/grade/judging/symbols.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto object = rt::grade::parse_object({reinterpret_cast<const char*>(data), size});
    if (!object) return 0;
    const rt::grade::StageFunctions functions{.own = {"_Z3ownv"}, .callable = {}, .others = {}};
    const bool defines_own =
        std::any_of(object->symbols.begin(), object->symbols.end(),
                    [](const auto& each) { return each.is_defined && each.name == "_Z3ownv"; });
    // What does not define the stage's function is refused, with a sentence of a readable length.
    const std::string sentence = rt::grade::foreign_symbol(*object, functions);
    if ((sentence.empty() && !defines_own) || sentence.size() > 2000) std::abort();
    return 0;
}

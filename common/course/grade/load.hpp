// How busy the machine is.
#pragma once

namespace rt::grade {

/// How many times as long as alone a program may take now by the clock: the processes that want to
/// run, for each processor, of the last minute; between 1 and 15. What a clock limits is given so
/// much more time on a busy machine.
[[nodiscard]] double busy();

}  // namespace rt::grade

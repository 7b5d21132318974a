// The picture at the end of a check.
#pragma once

namespace rt {

/// Draws the picture of the checked files, by the program stepNN_name_checked (common/cmake/
/// stage.cmake), and writes it beside the reference's to a file, whose path it prints. They are
/// small, to be drawn in a moment; `./course compare` draws the whole ones. `is_wrong` is true if
/// a case fails: then the same picture is no praise. Returns false if the program draws none, or
/// another one with one thread.
[[nodiscard]] bool show_picture(int stage, bool is_wrong);

}  // namespace rt

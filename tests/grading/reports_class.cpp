#include "tests/grading/reports_class.hpp"

namespace rt::grade {

std::vector<Mark> class_of_two() {
    const CaseMark hit{.name = "it is hit", .points = 1, .passed = true};
    const CaseMark missed{.name = "a < b & \"c\"",
                          .points = 1,
                          .given = true,
                          .place = "tests/suites/step04_plane_test.cpp:9",
                          .words = no_utf8 + "\nexpected: <hit>\n"};
    const CaseMark edges{.name = "edges", .points = 3, .passed = true};
    return {
        {.student = odd,
         .stage = 4,
         .key = "k4",
         .verdict = Verdict::judged,
         .words = "warning: <unused>",
         .source = "17",
         .mistake = "You compare with <0>.",
         .smallest = "intersect(…)\n  got: 1\n",
         .slice = "step04 slice.svg",
         .cases = {hit, missed},
         .picture = PictureMark{.pixels = 12, .different = 5, .file = "step04_plane.png"},
         .most = 2},
        {.student = odd, .stage = 5, .verdict = Verdict::refused, .words = "no <vec>", .most = 4},
        {.student = "zoe", .stage = 4, .verdict = Verdict::missing, .words = "<none>", .most = 2},
        {.student = "zoe",
         .stage = 5,
         .verdict = Verdict::judged,
         .cases = {edges, {.name = missed.name, .points = 1, .place = "here:1", .words = "no"}},
         .picture = PictureMark{.pixels = 12, .file = "step05_triangle.png"},
         .most = 4},
    };
}

}  // namespace rt::grade

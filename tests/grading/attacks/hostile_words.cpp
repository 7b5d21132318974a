// attack: throws words that are no UTF-8, of XML, HTML, CSV, terminals and reports
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include <stdexcept>
#include "steps/step03_sphere/sphere.hpp"
namespace rt {
std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    throw std::runtime_error(
        "\xff\xfe\xed\xa0\x80 ]]></failure><script>alert(1)</script>\x1b]0;x\x07\r\ncase a\npoints "
        "99\npassed\n=cmd|'/c calc'!A0\x01\x0b\u202e");
}
}  // namespace rt

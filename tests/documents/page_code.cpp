// page_code <output> <page>... : the C++ of the pages, as a source of the suite "pages". Shown code
// must compile, its checks must pass, and its answers must be the reference's.
#include "tests/documents/page.hpp"

namespace {

constexpr const char* head = R"(#include "steps/step05_triangle/triangle.hpp"

#include "tests/kit/shape_checks.hpp"

namespace {

/// The text of a result, as a failure prints it; without an interval, the whole one.
template <class Shape>
std::string answer(const rt::Ray& ray, const Shape& shape, rt::Interval interval = {}) {
    return rt::got_text(intersect(ray, shape, interval));
}

}  // namespace
)";

std::string without(std::string text, const std::string& part) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part))
        text.erase(at, part.size());
    return text;
}

/// `Real(3.875)` is 3.875 in an answer.
std::string plain(const std::string& answer) {
    return without(without(answer, "Real("), ")");
}

std::string source(const rt::PageCode& code, const std::string& place) {
    using Kind = rt::PageCode::Kind;
    if (code.kind == Kind::file) return "\n// " + place + "\n" + code.text;
    const std::string body = code.kind == Kind::check
                                 ? code.text
                                 : "CHECK(" + ("answer" + code.text.substr(code.text.find('('))) +
                                       " == \"" + plain(code.expected) + "\");";
    return "\nTEST_CASE(\"" + place + "\") {\n    using namespace rt;\n    " + body + "\n}\n";
}

}  // namespace

int main(int argc, char** argv) {
    std::ofstream out(argv[1]);
    out << head;
    for (int i = 2; i < argc; ++i) {
        const std::filesystem::path page = argv[i];
        for (const rt::PageCode& code : code_of(rt::read_page(page)))
            out << source(
                code, "docs/" + page.filename().string() + ":" + std::to_string(code.first_line));
    }
    out.close();
    return out ? 0 : 1;
}

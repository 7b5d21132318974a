// Whole pictures in float, in double and by certified kernels.
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

namespace rt::accuracy {

namespace {

/// The time in units of double's.
double cost(const std::vector<Row>& rows, const std::string& precision) {
    return middle(where(rows, {{"precision", precision}}), "seconds") /
           middle(where(rows, {{"precision", "double"}}), "seconds");
}

std::string table(const std::vector<Row>& rows) {
    std::string text =
        "| scene | time: float | exact | pixels other than exact's, of 100,000: double "
        "| float | by more than 2 steps | on an edge |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const std::string& scene : different(rows, "scene")) {
        const auto own = where(rows, {{"scene", scene}});
        const auto share = [&](const char* precision, const char* column) {
            return " | " + thousands(1e5 * middle(where(own, {{"precision", precision}}), column));
        };
        text += "| `" + scene + "` | " + two_digits(cost(own, "float")) + " | " +
                two_digits(cost(own, "exact")) + share("double", "other") +
                share("float", "other") + share("float", "seen") + share("float", "edges") + " |\n";
    }
    return text;
}

}  // namespace

Study pictures(const std::filesystem::path& folder) {
    return {.plots = {}, .tables = {{"pictures", table(read_csv(folder / "pictures.csv"))}}};
}

}  // namespace rt::accuracy

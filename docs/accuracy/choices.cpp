// What --tolerance and --time choose, in every scene.
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

#include <cstdio>

namespace rt::accuracy {

namespace {

/// "99.3 % in 1.1": how many pixels keep the tolerance, and the time in units of the best's.
std::string of_tolerance(const std::vector<Row>& rows, const std::string& asked) {
    const auto own = where(rows, {{"goal", "tolerance"}, {"asked", asked}});
    char share[16];
    std::snprintf(share, sizeof share, "%.1f %%", 100 * middle(own, "kept"));
    return std::string(share) + " | " + two_digits(middle(own, "seconds") / middle(own, "best"));
}

std::string of_time(const std::vector<Row>& rows, const std::string& asked) {
    return two_digits(middle(where(rows, {{"goal", "time"}, {"asked", asked}}), "seconds")) + " s";
}

std::string table(const std::vector<Row>& rows) {
    std::string text =
        "| scene | `--tolerance 1`: kept by | time | `--tolerance 4`: kept by | time "
        "| `--time 1` | `--time 3` |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const std::string& scene : different(rows, "scene")) {
        const auto own = where(rows, {{"scene", scene}});
        text += "| `" + scene + "` | " + of_tolerance(own, "1") + " | " + of_tolerance(own, "4") +
                " | " + of_time(own, "1") + " | " + of_time(own, "3") + " |\n";
    }
    return text;
}

}  // namespace

Study choices(const std::filesystem::path& folder) {
    return {.plots = {}, .tables = {{"choices", table(read_csv(folder / "choices.csv"))}}};
}

}  // namespace rt::accuracy

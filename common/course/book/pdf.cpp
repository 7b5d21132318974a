#include "common/course/book/pdf.hpp"

#include "common/course/build/project.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/status_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::minutes print_time_limit{2};

/// The browser's command, which systems call differently. Throws InputError if there is none.
std::string browser() {
    for (const std::string name : {"chromium", "chromium-browser", "google-chrome"})
        if (is_installed(name)) return name;
    throw InputError({}, "book: --pdf needs chromium, or what your system calls it");
}

fs::path folder_of(const fs::path& destination) {
    return fs::absolute(destination / "").lexically_normal().parent_path();
}

/// Prints a page on A4. Its figures' scripts are not run from a file, so these are the drawn ones.
void print_page(const std::string& browser, const fs::path& page, const fs::path& pdf,
                const fs::path& profile) {
    std::string text = read_text(page);
    text.insert(std::min(text.find("</head>"), text.size()), "<style>@page { size: A4 }</style>");
    write_text(page, text);
    Command command{browser,
                    "--headless",
                    "--disable-gpu",
                    "--disable-quic",
                    "--no-first-run",
                    "--disable-background-networking",
                    "--disable-component-update",
                    "--disable-sync",
                    "--user-data-dir=" + profile.string(),
                    "--no-pdf-header-footer",
                    "--print-to-pdf-no-header",
                    "--print-to-pdf=" + pdf.string(),
                    "file://" + page.string()};
    if (geteuid() == 0) command.insert(command.begin() + 1, "--no-sandbox");
    const ProcessResult ending = run_captured(command, print_time_limit);
    if (!fs::exists(pdf))
        throw ProgramError("error: " + browser + " has not printed " + page.string() + "\n" +
                           ending.output);
}

}  // namespace

void check_printing(const fs::path& destination) {
    if (destination.empty()) throw InputError({}, "book: expected a name, not \"\"");
    refuse_what_is_there(destination, folder_of(destination));
    (void)browser();
    if (!is_installed("pdfunite"))
        throw InputError({}, "book: --pdf needs pdfunite, of poppler-utils");
}

void print_pages(const fs::path& site, const fs::path& destination) {
    check_printing(destination);
    const fs::path target = folder_of(destination);
    const std::string chromium = browser();
    fs::create_directories(target.parent_path());
    const TemporaryFolder workshop(target.parent_path());
    const fs::path folder = workshop.path() / "pdf";
    fs::create_directory(folder);
    const fs::path copy = workshop.path() / "site";
    fs::copy(site, copy, fs::copy_options::recursive);
    Command unite{"pdfunite"};
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        fs::path page = copy / project_language() / (name_of(stage) + ".html");
        if (!fs::exists(page)) page = copy / page.filename();
        if (!fs::exists(page)) continue;  // a hand-out may leave out a stage
        StatusLine status("printing " + name_of(stage) + " …");
        const fs::path pdf = folder / (name_of(stage) + ".pdf");
        print_page(chromium, page, pdf, workshop.path() / "profile");
        unite.push_back(pdf.string());
    }
    unite.push_back((folder / "course.pdf").string());
    const ProcessResult ending = run_captured(unite, print_time_limit);
    if (ending.status != 0) throw ProgramError("error: pdfunite failed\n" + ending.output);
    fs::rename(folder, target);
}

}  // namespace rt

#include "common/course/book/site.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/stages/stages.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <regex>
#include <set>
#include <string>

namespace rt {

namespace {

constexpr std::chrono::minutes build_time_limit{20};
constexpr const char* list_of_files = "book.txt";

/// A line for each file of the site: its fingerprint and its path.
std::string fingerprints(const fs::path& site) {
    std::set<std::string> paths;
    for (const auto& entry : fs::recursive_directory_iterator(site))
        if (entry.is_symlink() || !entry.is_directory())
            paths.insert(entry.path().lexically_relative(site).string());
    paths.erase(list_of_files);
    std::string lines = "Raysteps, its pages as a site\n";
    for (const std::string& path : paths) lines += fingerprint(site / path) + " " + path + "\n";
    return lines;
}

/// True if the folder contains what write_site has written, and nothing else.
bool is_unchanged_site(const fs::path& folder) {
    return fs::is_regular_file(folder / list_of_files) &&
           read_text(folder / list_of_files) == fingerprints(folder);
}

void refuse_what_is_no_site(const fs::path& destination, const fs::path& target) {
    const bool is_site =
        fs::symlink_status(target).type() == fs::file_type::directory && is_unchanged_site(target);
    if (!is_free_for_folder(target) && !is_site)
        throw InputError({destination.string()},
                         "exists already: expected a new name, an empty folder, or a book in "
                         "which nothing was changed");
}

/// Builds what the live figures call. Without it the site has the drawn figures.
void build_engine() {
    const bool is_built = try_build({"book_engine"}).succeeded;
    if (!is_built || !fs::exists(build_folder / "engine/engine_double.wasm"))
        std::cerr << tr("The figures do not run: they need clang, lld, wasi-libc and what "
                        "docs/reference/figures.md names.")
                  << '\n';
}

void run_mkdocs(const fs::path& project, const fs::path& site, const std::string& source) {
    const fs::path pages = project / "common/course/book/mkdocs.yml";
    const ProcessResult ending =
        run_captured({"env", "PYTHONDONTWRITEBYTECODE=1", "RAYSTEPS_SOURCE=" + source,
                      "RAYSTEPS_ENGINE=" + (build_folder / "engine").string(), "mkdocs", "build",
                      "--quiet", "--config-file", pages.string(), "--site-dir", site.string()},
                     build_time_limit);
    const bool has_parts = ending.output.find("Unrecognised theme name") == std::string::npos &&
                           ending.output.find("katex.js") == std::string::npos;
    if (ending.status == 127 || !has_parts)
        throw InputError({},
                         "the book needs mkdocs-material (with mkdocs from version 1.4 on) and "
                         "katex, or what your system calls them");
    if (ending.out_of_time)
        throw InputError({}, "the book took more than 20 minutes: this machine is too busy");
    if (ending.status != 0) throw ProgramError(ending.output);
    std::cerr << ending.output;  // warnings
}

}  // namespace

void write_site(const fs::path& project, const fs::path& destination, const std::string& source) {
    if (destination.empty()) throw InputError({}, "book: expected a name, not \"\"");
    const fs::path target = fs::absolute(destination / "").lexically_normal().parent_path();
    refuse_what_is_no_site(destination, target);
    build_engine();

    // Beside it until it is whole.
    fs::create_directories(target.parent_path());
    const TemporaryFolder workshop(target.parent_path());
    const fs::path site = workshop.path() / "new";
    run_mkdocs(project, site, source);
    write_text(site / list_of_files, fingerprints(site));
    refuse_what_is_no_site(destination, target);  // it may have been changed meanwhile
    if (fs::exists(target)) fs::rename(target, workshop.path() / "old");
    fs::rename(site, target);
}

std::string address_on_github(const fs::path& project) {
    const ProcessResult remote =
        run_captured({"env", "git", "-C", project.string(), "-c",
                      "safe.directory=" + project.string(), "remote", "get-url", "origin"},
                     build_time_limit);
    static const std::regex name(
        R"(^(?:https://|git@)github\.com[/:]([\w.-]+/[\w.-]+?)(\.git)?\s*$)");
    std::smatch found;
    if (remote.status != 0 || !std::regex_match(remote.output, found, name)) return "";
    return "https://github.com/" + found[1].str() + "/blob/HEAD";
}

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

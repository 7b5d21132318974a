#include "common/course/book/book.hpp"

#include "common/course/book/site.hpp"
#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/course/view/server.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <vector>

namespace rt {

namespace {

/// Nothing is loaded from other hosts. The theme has scripts and styles in its pages.
constexpr const char* policy =
    "default-src 'self'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; "
    "style-src 'self' 'unsafe-inline'; img-src 'self' data:; base-uri 'self'; frame-ancestors "
    "'none'";

std::string type_of(const fs::path& file) {
    static const std::map<std::string, std::string> types = {
        {".css", "text/css"},          {".html", "text/html; charset=utf-8"},
        {".js", "text/javascript"},    {".json", "application/json"},
        {".png", "image/png"},         {".svg", "image/svg+xml"},
        {".wasm", "application/wasm"}, {".webp", "image/webp"},
        {".woff2", "font/woff2"},
    };
    const auto found = types.find(file.extension().string());
    return found == types.end() ? "text/plain; charset=utf-8" : found->second;
}

/// The names in a folder, a link each.
std::string listing(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string() + (entry.is_directory() ? "/" : ""));
    std::ranges::sort(names);
    std::string page = "<!DOCTYPE html>\n<title>Raysteps</title>\n<ul>\n";
    for (const std::string& name : names)
        if (name.find_first_of("<>&\"%?#") == std::string::npos)
            page += "<li><a href=\"./" + name + "\">" + name + "</a>\n";
    return page + "</ul>\n";
}

/// Returns whether a name, relative to a folder, is in the folder and no part of it is hidden.
bool is_open(const fs::path& name) {
    const auto is_hidden = [](const fs::path& part) { return part.string().starts_with('.'); };
    return !name.empty() && name.is_relative() && std::ranges::none_of(name, is_hidden);
}

/// A file of the project or of its site. A symbolic link leads to no other file.
Response file_of(const fs::path& project, const std::string& path) {
    const fs::path wanted = fs::path(path).lexically_normal();
    std::error_code none;  // a name may be too long, or of no file
    const fs::path file = fs::canonical(project / wanted, none);
    const fs::path site = site_of_clone;
    const fs::path build = site.parent_path();
    const fs::path of_project = file.lexically_relative(fs::canonical(project, none));
    const fs::path of_build = file.lexically_relative(fs::canonical(project / build, none));
    const bool is_of_project = is_open(of_project) && *of_project.begin() != build;
    const bool is_of_site = is_open(of_build) && *of_build.begin() == site.filename();
    const fs::file_type type = fs::status(file, none).type();
    const bool is_page = type == fs::file_type::regular || type == fs::file_type::directory;
    if (!is_open(wanted) || !(is_of_project || is_of_site) || !is_page)
        throw Refusal{404, "there is no such page, or this hand-out does not contain the file"};
    if (type == fs::file_type::regular)
        return {.body = read_text(file), .type = type_of(file), .policy = policy};
    if (path.empty() || path.back() != '/') throw Refusal{404, "a folder's address ends with /"};
    return {.body = listing(file), .type = "text/html; charset=utf-8"};
}

void check_source(const std::string& source) {
    const bool is_address = source.starts_with("https://") || source.starts_with("http://");
    if (!is_address || source.find_first_of(" \t\n\"'<>\\") != std::string::npos)
        throw InputError({},
                         "book: --source: expected an address, such as "
                         "https://github.com/NAME/raysteps/blob/main, not \"" +
                             source + "\"");
}

/// The first page that is shown, in the reader's language if the site has it.
std::string first_page(const fs::path& project, const std::string& site) {
    const std::string own = site + "/" + project_language() + "/index.html";
    return !project_language().empty() && fs::exists(project / own) ? own : site + "/index.html";
}

}  // namespace

int book(const BookSettings& settings) {
    if (!settings.source.empty()) check_source(settings.source);
    if (settings.out) {
        write_site(settings.project, *settings.out,
                   settings.source.empty() ? address_on_github(settings.project) : settings.source);
        print_line(tr("{folder}: open index.html", {{"folder", *settings.out}}));
        return 0;
    }
    if (settings.pdf) check_printing(*settings.pdf);
    const bool is_clone = !is_handout(settings.project);
    const std::string site = is_clone ? site_of_clone : site_of_handout;
    if (is_clone) {
        fs::remove_all(settings.project / site);  // the build folder has nothing of the user's
        write_site(settings.project, settings.project / site, project_from_site);
    }
    if (!fs::exists(settings.project / site))
        throw InputError({}, "this hand-out does not contain the book: read docs/README.md");
    if (settings.pdf) {
        print_pages(settings.project / site, *settings.pdf);
        print_line(
            tr("{folder}: a PDF for each stage, and course.pdf", {{"folder", *settings.pdf}}));
        return 0;
    }
    Host host(0);
    std::atomic<bool> over = false;
    host.serve(
        first_page(settings.project, site),
        [&](const Request& request) {
            if (request.path == "own_answer") return own_answer(request, over);
            if (request.path == "own_files") return own_files();
            if (request.path == site + "/figures/mine.js") return own_answer_address();
            return file_of(settings.project, request.path);
        },
        [&over] { over = true; });
    return 0;
}

namespace {

constexpr std::chrono::seconds answer_limit{30};  // call_once has a shorter one, of computing time
constexpr std::size_t longest_question = 4096;    // in digits

/// The names and the times of the student's files of a stage; empty if there are none.
std::string state_of_files(int stage) {
    std::set<std::string> files;
    std::error_code none;
    for (const auto& entry :
         fs::directory_iterator(project_folder / step_path(stage, "student"), none))
        if (entry.path().extension() == ".cpp" && entry.path().filename() != trace_file)
            files.insert(entry.path().string() + " " +
                         std::to_string(
                             std::int64_t(entry.last_write_time(none).time_since_epoch().count())) +
                         "\n");
    std::string state;
    for (const std::string& file : files) state += file;
    return state;
}

/// The last build of a worker.
struct Built {
    std::string from;
    std::string error;
};

/// Builds the worker if its files have changed. Throws Refusal with the first error.
void bring_up_to_date(int stage, const std::string& worker) {
    static std::mutex one_at_a_time;
    static std::map<std::string, Built> built;
    const std::scoped_lock lock(one_at_a_time);
    const std::string files = state_of_files(stage);
    if (files.empty())
        throw Refusal{422, "nothing is started: ./course start " + std::to_string(stage)};
    Built& last = built[worker];
    if (last.from != files) {
        const Build build = try_build({"call_once", worker});
        last = {.from = files, .error = build.succeeded ? "" : first_error(build.output)};
    }
    if (!last.error.empty()) throw Refusal{422, last.error};
}

std::string question_of(const Request& request, int stage) {
    const auto found = request.parameters.find("question");
    const std::string digits = found == request.parameters.end() ? "" : found->second;
    if (digits.size() < 4 || digits.size() % 2 != 0 || digits.size() > longest_question ||
        digits.find_first_not_of("0123456789abcdef") != std::string::npos)
        throw Refusal{400, "question: expected an even number of hexadecimal digits, 4 to " +
                               std::to_string(longest_question)};
    if (std::stoi(digits.substr(0, 2), nullptr, 16) != stage)
        throw Refusal{400, "question: expected one to stage " + std::to_string(stage)};
    return digits;
}

std::string bytes_of(const std::string& digits) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes += char(std::stoi(digits.substr(i, 2), nullptr, 16));
    return bytes;
}

}  // namespace

Response own_answer_address() {
    return {.body =
                "export const mine = \"../../../own_answer\";\n"
                "export const files = \"../../../own_files\";\n",
            .type = "text/javascript"};
}

Response own_files() {
    std::string all;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) all += state_of_files(stage);
    return {.body = all, .type = "text/plain; charset=utf-8"};
}

Response own_answer(const Request& request, const std::atomic<bool>& cancelled) {
    const int stage = whole_number(request, "stage", 1, int(stage_names.size()));
    const bool is_float = whole_number(request, "precision", 0, 1) == 1;
    const std::string question = question_of(request, stage);
    const std::string worker = stage_target(stage, is_float ? "_worker_float" : "_worker_double");
    bring_up_to_date(stage, worker);
    const ProcessResult called = run_captured(
        {(build_folder / "call_once").string(), (build_folder / worker).string(), question},
        answer_limit, &cancelled);
    if (called.out_of_time) throw Refusal{422, "your code gave no answer within 30 s"};
    const std::string printed = called.output.substr(0, called.output.find('\n'));
    if (called.status != 0) throw Refusal{422, printed};
    return {.body = bytes_of(printed), .type = "application/octet-stream"};
}

}  // namespace rt

#include "common/course/book/book.hpp"

#include "common/course/book/own_answers.hpp"
#include "common/course/book/pdf.hpp"
#include "common/course/book/site.hpp"
#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/course/view/host.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>
#include <vector>

namespace rt {

namespace fs = std::filesystem;

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
    std::sort(names.begin(), names.end());
    std::string page = "<!DOCTYPE html>\n<title>Raysteps</title>\n<ul>\n";
    for (const std::string& name : names)
        if (name.find_first_of("<>&\"%?#") == std::string::npos)
            page += "<li><a href=\"./" + name + "\">" + name + "</a>\n";
    return page + "</ul>\n";
}

/// Returns whether a name, relative to a folder, is in the folder and no part of it is hidden.
bool is_open(const fs::path& name) {
    const auto is_hidden = [](const fs::path& part) { return part.string().starts_with('.'); };
    return !name.empty() && name.is_relative() && std::none_of(name.begin(), name.end(), is_hidden);
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
    const bool is_address = source.rfind("https://", 0) == 0 || source.rfind("http://", 0) == 0;
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
        std::puts(tr("{folder}: open index.html", {{"folder", *settings.out}}).c_str());
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
        std::puts(tr("{folder}: a PDF for each stage, and course.pdf", {{"folder", *settings.pdf}})
                      .c_str());
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

}  // namespace rt

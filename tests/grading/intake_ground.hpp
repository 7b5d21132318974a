// Untrusted folders and archives for the tests of their intake.
#pragma once

#include "common/course/grade/judging/class_folder.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <fstream>

namespace rt::grade {

/// The text of each file that is taken.
using Files = std::map<GradedFile, std::string>;

/// A class to be, and a workshop, in a folder of their own.
class Ground {
public:
    /// `sealed` is the launcher; the program `unpack` is beside it.
    explicit Ground(const std::filesystem::path& sealed) {
        std::filesystem::permissions(folder_, std::filesystem::perms(0755));
        for (const char* each : {"class", "workshop"})
            std::filesystem::create_directory(folder_ / each);
        std::filesystem::permissions(folder_ / "workshop", std::filesystem::perms(0755));
        workshop_ = {.folder = folder_ / "workshop", .sealed = sealed};
        std::filesystem::copy_file(workshop_.sealed.parent_path() / "unpack",
                                   folder_ / "workshop/unpack");
    }

    [[nodiscard]] const BuildDirectory& workshop() const { return workshop_; }

    [[nodiscard]] std::filesystem::path place(const std::string& name) const {
        return folder_ / "class" / name;
    }

    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(place(name).parent_path());
        std::ofstream(place(name)) << text;
    }

    /// An archive of the contents of one of the folders.
    void pack(const std::string& archive, const std::string& from, const Command& words) const {
        Command tar{"tar", "-C", place(from), "-cf", place(archive)};
        tar.insert(tar.end(), words.begin(), words.end());
        REQUIRE(run_captured(tar, std::chrono::seconds(20)).status == 0);
        std::filesystem::remove_all(place(from));
    }

    /// A zip of a folder's contents, unchanged.
    void zip(const std::string& from, const std::string& archive) const {
        const std::filesystem::path to = place(archive);
        std::filesystem::create_directories(to.parent_path());
        Command zip{"cmake", "-E", "chdir", place(from),    "cmake", "-E",
                    "tar",   "cf", to,      "--format=zip", "--"};
        for (const auto& each : std::filesystem::directory_iterator(place(from)))
            zip.push_back(each.path().filename());
        REQUIRE(run_captured(zip, std::chrono::seconds(60)).status == 0);
        std::filesystem::remove_all(place(from));
    }

    [[nodiscard]] SubmittedFiles take(const std::string& name) const {
        return take_in(workshop_, {.student = "s", .pieces = {{place(name), name}}});
    }

    [[nodiscard]] SubmittedFiles take(const Submission& submission) const {
        return take_in(workshop_, submission);
    }

    /// An archive is a class.
    [[nodiscard]] ClassFolder find_packed(const std::vector<std::filesystem::path>& places) const {
        return find_class(workshop_, places, {}, true);
    }

    [[nodiscard]] std::vector<std::string> students() const {
        std::vector<std::string> names;
        for (const Submission& each : find({folder_ / "class"}).submissions)
            names.push_back(each.student);
        return names;
    }

    [[nodiscard]] ClassFolder find(const std::vector<std::filesystem::path>& places,
                                   const std::filesystem::path& results = {}) const {
        return find_class(workshop_, places, results);
    }

    /// By student: the submissions of a class that consists of these only.
    [[nodiscard]] std::map<std::string, SubmittedFiles> take_class() const {
        std::map<std::string, SubmittedFiles> all;
        for (const Submission& each : find({folder_ / "class"}).submissions)
            all[each.student] = take_in(workshop_, each);
        return all;
    }

private:
    TemporaryFolder temporary_;
    const std::filesystem::path& folder_ = temporary_.path();
    BuildDirectory workshop_;
};

}  // namespace rt::grade

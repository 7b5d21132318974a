// The compiler's warnings about the student's files, and the symbols of their objects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// A student's file, compiled in double since it changed.
struct CompiledFile {
    int stage = 0;
    std::filesystem::path file;
    std::filesystem::path object;
};

/// These files of a stage.
[[nodiscard]] std::vector<CompiledFile> compiled_files(int stage);

/// True for the path of a student's object in the build folder.
[[nodiscard]] bool is_student_object(const std::string& path);

/// Makes objects older than the student's files that were saved since the build began: ninja
/// compares a file with the end of its compile, so it would not compile them again.
void outdate_objects(std::filesystem::file_time_type build_began);

/// Keeps the compiler's output on an object beside it: it is printed only when a file is compiled.
void keep_warnings(const std::filesystem::path& object, const std::string& output);

/// The kept output on the student's files of a stage, as they were last compiled.
[[nodiscard]] std::string kept_warnings(int stage);

/// A symbol that files of two stages define, so that no program can be linked from both.
struct SharedSymbol {
    std::string name;  ///< "rt::solve(float, float)"
    std::filesystem::path file;
    std::filesystem::path other_file;  ///< of another stage
};

/// These symbols of a stage's files. Of other stages, only files that were compiled since they
/// changed are known.
[[nodiscard]] std::vector<SharedSymbol> shared_symbols(int stage);

}  // namespace rt

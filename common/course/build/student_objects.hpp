// The compiler's warnings about the student's files, and the symbols of their objects.
#pragma once

#include "common/system/files.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A symbol of an object.
struct Symbol {
    std::string name;  ///< as in the source: "rt::solve(float, float)"
    char kind = ' ';   ///< nm's letter
    std::string section = {};
};

/// The symbol in a line of nm's System V format, "NAME|VALUE| KIND |TYPE|SIZE|LINE|SECTION"; none
/// in other lines.
[[nodiscard]] std::optional<Symbol> read_symbol(const std::string& line);

/// A student's file, compiled in double since it changed.
struct CompiledFile {
    int stage = 0;
    fs::path file;
    fs::path object;
    std::vector<Symbol> symbols = {};
};

/// These files of all stages.
[[nodiscard]] std::vector<CompiledFile> compiled_files();

/// True for the path of a student's object in the build folder.
[[nodiscard]] bool is_student_object(const std::string& path);

/// Makes objects older than the student's files that were saved since the build began: ninja
/// compares a file with the end of its compile, so it would not compile them again.
void outdate_objects(fs::file_time_type build_began);

/// Keeps the compiler's output on an object beside it: it is printed only when a file is compiled.
void keep_warnings(const fs::path& object, const std::string& output);

/// The kept output on the student's files of a stage, as they were last compiled.
[[nodiscard]] std::string kept_warnings(int stage);

/// A symbol that files of two stages define, so that no program can be linked from both.
struct SharedSymbol {
    std::string name;  ///< "rt::solve(float, float)"
    fs::path file;
    fs::path other_file;  ///< of another stage
};

/// These symbols of the files of a stage.
[[nodiscard]] std::vector<SharedSymbol> shared_symbols(int stage,
                                                       const std::vector<CompiledFile>& files);

}  // namespace rt

// The folder where mutants of a stage are compiled and tested by its suite. POSIX.
#pragma once

#include "common/system/files.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace mutation {

enum class Fate {
    not_compiled,
    same_code,  ///< it compiles to the reference's own code
    killed,
    survived,
};

struct Outcome {
    Fate fate;
    std::vector<std::string> killers;  ///< the cases that failed: the first one, or all
};

/// The stage's suites are linked in advance, without the stage's library. Each mutant becomes that
/// library.
class BuildDirectory {
public:
    /// Throws std::runtime_error if the reference does not pass.
    BuildDirectory(const std::string& stage, const std::string& reference, bool every_case);

    /// The result of the double suite on a source and, if it finds nothing, of the float suite.
    [[nodiscard]] Outcome judge(const std::string& source) const;

    /// The suite's cases, by name.
    [[nodiscard]] const std::vector<std::string>& cases() const { return cases_; }

private:
    struct Precision {
        std::filesystem::path options;    ///< the compiler's
        std::filesystem::path prelude;    ///< the includes of the source, precompiled
        std::filesystem::path library;    ///< the tested library
        std::filesystem::path suite;      ///< the program that judges it
        std::string code_of_reference{};  ///< the library's
    };

    void prepare(Precision& precision, const std::string& reference);
    [[nodiscard]] bool compile(const Precision& precision, const std::string& source) const;
    [[nodiscard]] Outcome judge(const Precision& precision, const std::string& source) const;

    rt::TemporaryFolder work_{RAYSTEPS_MUTATION_FOLDER};
    std::filesystem::path source_ = work_.path() / "mutant.cpp";
    std::filesystem::path report_ = work_.path() / "report";
    std::vector<Precision> precisions_;
    std::vector<std::string> suite_options_;
    std::vector<std::string> cases_;
    int seconds_ = 60;  ///< processor time limit of a suite
};

}  // namespace mutation

// The folder where mutants of a stage are compiled and tested by its suite. POSIX.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
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
    BuildDirectory(const BuildDirectory&) = delete;
    BuildDirectory& operator=(const BuildDirectory&) = delete;
    ~BuildDirectory();

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

    std::filesystem::path work_;  ///< this process' own
    std::filesystem::path source_;
    std::filesystem::path report_;
    std::vector<Precision> precisions_;
    std::vector<std::string> suite_options_;
    std::vector<std::string> cases_;
    int seconds_ = 60;  ///< processor time limit of a suite
};

// Whole files, read and written.

/// Throws std::runtime_error if it cannot be read.
[[nodiscard]] inline std::string content_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Throws std::runtime_error if it cannot be written.
inline void write(const std::filesystem::path& file, const std::string& content) {
    std::ofstream stream(file, std::ios::binary);
    if (!(stream << content).flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace mutation

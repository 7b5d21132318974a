// The lines "word: value" of a lecturer's term.txt.
#pragma once

#include "common/course/grade/results/csv.hpp"
#include "common/system/input_error.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace rt::grade {

struct Settings {
    struct Word {
        std::string value;
        int line = 0;
    };
    std::filesystem::path file;
    std::map<std::string, Word> words;  ///< all that may be there once
    std::map<int, double> weights;      ///< by stage
    std::map<int, bool> bonus;

    [[nodiscard]] FileLocation place(const std::string& word) const;

    /// The number of a setting, from 0 to `most`; 0 if it is not there. Throws InputError.
    [[nodiscard]] double number(const std::string& word, double most) const;

    /// The table that a setting names, beside this file; nothing if there is no such setting.
    /// Throws InputError.
    [[nodiscard]] std::optional<Csv> table(const std::string& word) const;
};

/// Throws InputError with the line.
[[nodiscard]] Settings read_settings(const std::filesystem::path& file);

/// Throws InputError for other text.
[[nodiscard]] double read_number(const std::string& text, const FileLocation& place, double least,
                                 double most);

/// "5" and "triangle". Throws InputError.
[[nodiscard]] int read_stage(const std::string& text, const FileLocation& place);

}  // namespace rt::grade

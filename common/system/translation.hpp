// Sentences in the reader's language. They are English in the code; their translations are in
// lang/LANGUAGE/….po, which is read when a program runs.
#pragma once

#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt {

/// The language that RAYSTEPS_LANG names, else LC_ALL, LC_MESSAGES or LANG, the first that is not
/// empty: "fr" of "fr_FR.UTF-8". Empty if none is.
[[nodiscard]] std::string language_of_environment();

/// A paragraph of a catalogue of gettext's form: an English text and its translation.
struct CatalogueEntry {
    std::string lines = {};
    std::string english = {};
    std::string own = {};
    bool is_fuzzy = false;  ///< the English text has changed since
};

/// The entries of a catalogue's text.
[[nodiscard]] std::vector<CatalogueEntry> catalogue_entries(const std::string& catalogue);

/// The entries of a catalogue, if there is one, that are neither fuzzy nor empty.
[[nodiscard]] std::vector<CatalogueEntry> translations_in(const std::filesystem::path& catalogue);

/// The variable with which ./course names a catalogue to a stage's program.
inline constexpr const char* sentences_variable = "RAYSTEPS_SENTENCES";

/// Reads them for tr and tr_text.
void read_translations(const std::filesystem::path& catalogue);

/// Removes those that were read.
void forget_translations();

/// A sentence that is translated where it is printed, not here.
[[nodiscard]] constexpr const char* to_translate(const char* english) {
    return english;
}

/// The translation of a sentence, or the sentence if it has none.
[[nodiscard]] std::string tr(const std::string& english);

/// A place in a sentence, and the text or the whole number that takes it.
struct NamedValue {
    std::string_view place;
    std::string text;

    NamedValue(std::string_view name, std::string words) : place(name), text(std::move(words)) {}
    NamedValue(std::string_view name, std::integral auto number)
        : NamedValue(name, std::to_string(number)) {}
};
using Values = std::vector<NamedValue>;

/// The same with values in the places of a sentence: tr("{some} of {all}", {{"some", "3"}, …}).
[[nodiscard]] std::string tr(const std::string& english, const Values& values);

/// The translation of a text that was put together elsewhere, by a suite or a stage's program: of
/// an entry that is the text, or that the text fits with values in its places. "a hit at t = 4"
/// fits "a hit at t = {t}". The values are translated too, and what has no translation stays.
[[nodiscard]] std::string tr_text(const std::string& text);

/// The same behind the blanks at the start of a line.
[[nodiscard]] std::string tr_line(const std::string& line);

/// The same for each line.
[[nodiscard]] std::string tr_lines(const std::string& text);

/// A text whose paragraphs, between empty lines, are translated.
[[nodiscard]] std::string paragraphs_translated(const std::string& english);

}  // namespace rt

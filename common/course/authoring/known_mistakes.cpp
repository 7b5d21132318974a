#include "common/course/authoring/known_mistakes.hpp"

#include "common/system/input_error.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>

namespace rt {

namespace {

std::string alternatives_of(const std::string& suite) {
    return "tests/alternatives/" + suite + ".cpp";
}

/// The file of what a catalogue calls `reference`, `main.cpp` or by the name of another answer.
std::string file_of(const std::string& right_answer, const std::string& suite) {
    const std::string stage = suite.substr(0, suite.find("_trace"));
    if (right_answer == "main.cpp") return "steps/" + stage + "/main.cpp";
    if (right_answer == "reference")
        return "steps/" + stage + "/reference/" + stage.substr(stage.find('_') + 1) + ".cpp";
    return alternatives_of(suite);
}

/// Reads a catalogue line by line.
class CatalogueReader {
public:
    CatalogueReader(const fs::path& project, std::string suite)
        : project_(project), suite_(std::move(suite)) {}

    std::vector<KnownMistake> read() {
        for (const std::string& line : lines_in(project_ / catalogue_of(suite_))) {
            ++number_;
            if (line.starts_with('#')) continue;
            if (line.empty())
                is_in_group_ = false;
            else if (line.starts_with("mistake "))
                begin(line);
            else if (mistakes_.empty() || !(is_field(line) || is_change(line)))
                fail(
                    "expected \"mistake NAME in RIGHT_ANSWER\", its origin, caught by and "
                    "sentence, and lines that begin with a space, - or +");
        }
        if (!mistakes_.empty()) end();
        return std::move(mistakes_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError({catalogue_of(suite_), number_}, what);
    }

    void begin(const std::string& line) {
        if (!mistakes_.empty()) end();
        std::istringstream words(line);
        std::string word, in, right_answer;
        KnownMistake mistake;
        words >> word >> mistake.name >> in >> right_answer;
        if (in != "in" || right_answer.empty()) fail("expected \"mistake NAME in RIGHT_ANSWER\"");
        if (words >> word) {
            if (word != "around") fail("expected \"around\", not \"" + word + "\"");
            while (words >> word) mistake.around.push_back(word);
        }
        for (const KnownMistake& other : mistakes_)
            if (other.name == mistake.name) fail(mistake.name + " is there twice");
        mistake.right_answer = file_of(right_answer, suite_);
        if (!fs::exists(project_ / mistake.right_answer))
            fail(mistake.right_answer + " does not exist");
        if (mistake.right_answer == alternatives_of(suite_)) {
            const auto answer = find_right_answer(project_, suite_, right_answer);
            if (!answer) fail(mistake.right_answer + " has no answer " + right_answer);
            mistake.right_text = answer->text;
            mistake.right_around = answer->around;
            mistake.right_answer += ", " + right_answer;
        } else {
            mistake.right_text = read_text(project_ / mistake.right_answer);
        }
        mistakes_.push_back(std::move(mistake));
        is_in_group_ = false;
    }

    void end() const {
        const KnownMistake& last = mistakes_.back();
        if (last.origin.empty() || last.caught_by.empty() || last.sentence.empty())
            fail(last.name + " ends here without its origin, caught by or sentence");
        if (last.changes.empty()) fail(last.name + " ends here without a change");
    }

    bool is_field(const std::string& line) {
        KnownMistake& mistake = mistakes_.back();
        for (const auto& [word, field] :
             {std::pair{"origin: ", &mistake.origin}, std::pair{"caught by: ", &mistake.caught_by},
              std::pair{"sentence: ", &mistake.sentence}})
            if (line.starts_with(word)) {
                if (!field->empty()) fail("stands twice: " + line);
                *field = line.substr(std::string(word).size());
                return true;
            }
        return false;
    }

    bool is_change(const std::string& line) {
        if (line[0] != ' ' && line[0] != '-' && line[0] != '+') return false;
        auto& changes = mistakes_.back().changes;
        if (!is_in_group_) changes.push_back({.old_lines = {}, .new_lines = {}, .line = number_});
        is_in_group_ = true;
        if (line[0] != '+') changes.back().old_lines.push_back(line.substr(1));
        if (line[0] != '-') changes.back().new_lines.push_back(line.substr(1));
        return true;
    }

    const fs::path& project_;
    std::string suite_;
    int number_ = 0;
    bool is_in_group_ = false;
    std::vector<KnownMistake> mistakes_;
};

}  // namespace

std::string catalogue_of(const std::string& suite) {
    return "tests/mistakes/" + suite + ".txt";
}

std::vector<RightAnswer> read_right_answers(const fs::path& project, const std::string& suite) {
    const std::string mark = "// right ";
    std::vector<RightAnswer> answers;
    for (const std::string& line : lines_in(project / alternatives_of(suite))) {
        if (line.starts_with(mark)) {
            std::istringstream words(line.substr(mark.size(), line.find(':') - mark.size()));
            RightAnswer& answer = answers.emplace_back();
            std::string around;
            words >> answer.name >> around;
            answer.around.assign(std::istream_iterator<std::string>(words), {});
        }
        if (!answers.empty()) answers.back().text += line + "\n";
    }
    for (RightAnswer& answer : answers)  // blank lines before the next one
        while (answer.text.ends_with("\n\n")) answer.text.pop_back();
    return answers;
}

std::optional<RightAnswer> find_right_answer(const fs::path& project, const std::string& suite,
                                             const std::string& name) {
    const std::vector<RightAnswer> answers = read_right_answers(project, suite);
    const auto found = std::ranges::find(answers, name, &RightAnswer::name);
    if (found == answers.end()) return std::nullopt;
    return *found;
}

std::vector<KnownMistake> read_known_mistakes(const fs::path& project, const std::string& suite) {
    if (!fs::exists(project / catalogue_of(suite))) return {};
    return CatalogueReader(project, suite).read();
}

namespace {

using Lines = std::vector<std::string>;

std::string text_of(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

bool is_of_a_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The line with another name for the function where it is called or defined.
std::string renamed(const std::string& line, const std::string& function, const std::string& name) {
    std::string text;
    std::size_t from = 0;
    const std::string call = function + "(";
    for (std::size_t at = line.find(call); at != std::string::npos; at = line.find(call, at + 1)) {
        if (at > 0 && is_of_a_name(line[at - 1])) continue;
        text += line.substr(from, at - from) + name;
        from = at + function.size();
    }
    return text + line.substr(from);
}

/// The only place of these lines.
std::size_t place_of(const KnownMistake::Change& change, const Lines& lines,
                     const FileLocation& where, const std::string& file) {
    std::optional<std::size_t> place;
    const auto& old = change.old_lines;
    for (auto at = lines.begin();; ++at) {
        at = std::search(at, lines.end(), old.begin(), old.end());
        if (at == lines.end()) break;
        if (place) throw InputError(where, "these lines are in " + file + " twice: add some");
        place = std::size_t(at - lines.begin());
    }
    if (!place) throw InputError(where, "these lines are not in " + file);
    return *place;
}

Lines after_changes(const KnownMistake& mistake, const Lines& lines, const std::string& catalogue) {
    std::map<std::size_t, const KnownMistake::Change*> at;
    for (const KnownMistake::Change& change : mistake.changes) {
        if (change.old_lines.empty()) continue;
        const FileLocation where{catalogue, change.line};
        const std::size_t place = place_of(change, lines, where, mistake.right_answer);
        if (!at.emplace(place, &change).second) throw InputError(where, "these lines change twice");
    }
    Lines changed;
    for (std::size_t i = 0; i < lines.size();) {
        const auto here = at.find(i);
        if (here == at.end()) {
            changed.push_back(lines[i++]);
            continue;
        }
        const auto& [old_lines, new_lines, line] = *here->second;
        changed.insert(changed.end(), new_lines.begin(), new_lines.end());
        const std::size_t end = i + old_lines.size();
        if (const auto next = at.upper_bound(i); next != at.end() && next->first < end)
            throw InputError({catalogue, next->second->line}, "these lines change twice");
        i = end;
    }
    return changed;
}

void rename(Lines& lines, const std::vector<std::string>& functions) {
    for (const std::string& function : functions)
        for (std::string& line : lines)
            if (!line.starts_with('#')) line = renamed(line, function, "correct_" + function);
}

/// The lines after those of the reference, which has other names for these functions; directives
/// come first.
std::string with_reference(const fs::path& project, const std::string& suite,
                           const std::vector<std::string>& around, const Lines& lines) {
    Lines all;
    if (!around.empty()) all = lines_of(read_text(project / file_of("reference", suite)));
    rename(all, around);
    all.insert(all.end(), lines.begin(), lines.end());
    std::ranges::stable_partition(all, [](const auto& line) { return line.starts_with('#'); });
    return text_of(all);
}

}  // namespace

std::string source_of(const fs::path& project, const std::string& suite,
                      const RightAnswer& answer) {
    return with_reference(project, suite, answer.around, lines_of(answer.text));
}

std::string source_of(const fs::path& project, const std::string& suite,
                      const KnownMistake& mistake) {
    Lines lines = after_changes(mistake, lines_of(mistake.right_text), catalogue_of(suite));
    rename(lines, mistake.around);
    const std::string end = "}  // namespace rt";
    for (const auto& change : mistake.changes)
        if (change.old_lines.empty()) {
            auto at = std::find(lines.rbegin(), lines.rend(), end);
            if (at == lines.rend())
                throw InputError({catalogue_of(suite), change.line},
                                 mistake.right_answer + " has no line \"" + end + "\"");
            Lines added = change.new_lines;
            added.push_back("");
            lines.insert(at.base() - 1, added.begin(), added.end());
        }
    return with_reference(project, suite, mistake.right_around, lines);
}

}  // namespace rt

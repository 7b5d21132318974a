#include "common/course/grade/results/likeness.hpp"

#include "common/course/grade/results/submissions.hpp"
#include "common/course/grade/results/winnowing.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace rt::grade {

namespace {

constexpr std::uintmax_t largest_source = 256 * 1024;
constexpr std::size_t fewest_passages = 8;   // about 40 tokens
constexpr std::size_t most_passages = 4096;  // no person writes more; the least hashes are a sample

struct Passage {
    std::uint64_t hash = 0;
    double weight = 0;
};

/// A file of a stage, without passages of the project.
struct Text {
    std::string student;
    std::string source;             ///< its SHA-256
    std::vector<Passage> passages;  ///< sorted by hash
    double weight = 0;
};

/// Empty for anything but a regular file of the size of a handwritten source.
std::string source_text(const fs::path& file) {
    std::error_code none;
    const bool is_file = fs::symlink_status(file, none).type() == fs::file_type::regular;
    const std::uintmax_t size = is_file ? fs::file_size(file, none) : 0;
    return size > 0 && size <= largest_source ? read_text(file) : "";
}

Text read(const Mark& mark, GradedFile graded, const fs::path& file,
          const std::vector<std::uint64_t>& given) {
    Text text{.student = mark.student, .source = graded.is_trace ? mark.trace_source : mark.source};
    for (const std::uint64_t hash : fingerprints(without_fillers(normalized(source_text(file)))))
        if (text.passages.size() < most_passages && !std::ranges::binary_search(given, hash))
            text.passages.push_back({.hash = hash});
    return text;
}

/// Rare passages weigh most: many students write the passages that the course suggests.
void weigh(std::vector<Text>& texts) {
    std::unordered_map<std::uint64_t, int> having;
    for (const Text& text : texts)
        for (const Passage& passage : text.passages) ++having[passage.hash];
    for (Text& text : texts)
        for (Passage& passage : text.passages) {
            passage.weight = std::log1p(double(texts.size()) / having[passage.hash]);
            text.weight += passage.weight;
        }
}

/// The passages that the project gives to every student.
std::vector<std::uint64_t> given_passages(const fs::path& project, GradedFile graded) {
    const fs::path stage = project / "steps" / name_of(graded.stage);
    std::vector<std::uint64_t> given;
    for (const fs::path& file : {stage / "starter" / file_name(graded), stage / "main.cpp"}) {
        if (!fs::exists(file) || (file.filename() == "main.cpp" && !graded.is_trace)) continue;
        const std::vector<std::uint64_t> more = passages(normalized(read_text(file)));
        given.insert(given.end(), more.begin(), more.end());
    }
    std::ranges::sort(given);
    return given;
}

std::vector<Text> texts_of(const fs::path& results, const fs::path& project,
                           const std::vector<Mark>& marks, GradedFile graded) {
    const std::vector<std::uint64_t> given = given_passages(project, graded);
    if (given.empty()) return {};
    std::vector<Text> texts;
    for (const Mark& mark : marks)
        if (mark.stage == graded.stage && mark.verdict != Verdict::missing)
            texts.push_back(
                read(mark, graded,
                     student_folder(results, mark.student) / "submitted" / submitted_name(graded),
                     given));
    weigh(texts);
    return texts;
}

int percent_alike(const Text& one, const Text& other) {
    double common = 0;
    auto next = other.passages.begin();
    for (const Passage& passage : one.passages) {
        while (next != other.passages.end() && next->hash < passage.hash) ++next;
        if (next != other.passages.end() && next->hash == passage.hash) common += passage.weight;
    }
    return int(100 * common / std::min(one.weight, other.weight) + 1e-9);
}

bool are_same(const Text& one, const Text& other) {
    return !one.source.empty() && one.source == other.source;
}

std::vector<SameFile> same_files(const std::vector<Text>& texts, GradedFile graded) {
    std::map<std::string, SameFile> by_source;
    for (const Text& text : texts) {
        if (text.source.empty() || text.passages.empty()) continue;
        SameFile& same = by_source[text.source];
        same.file = graded;
        same.students.push_back(text.student);
    }
    std::vector<SameFile> all;
    for (auto& [source, same] : by_source)
        if (same.students.size() > 1) all.push_back(std::move(same));
    return all;
}

using Pairs = std::map<std::pair<std::string, std::string>, NearFiles>;

void compare_all(const std::vector<Text>& texts, GradedFile graded, Pairs& pairs) {
    for (auto one = texts.begin(); one != texts.end(); ++one) {
        if (one->passages.size() < fewest_passages) continue;
        for (auto other = one + 1; other != texts.end(); ++other) {
            if (other->passages.size() < fewest_passages || are_same(*one, *other)) continue;
            const int percent = percent_alike(*one, *other);
            if (percent < near_percent) continue;
            NearFiles& near = pairs[{one->student, other->student}];
            near.one = one->student;
            near.other = other->student;
            near.percent[graded] = percent;
        }
    }
}

/// Returns the graded main.cpp files that are like the project's. A refused copy is not among them,
/// because its text is not stored.
std::vector<LikeMain> like_main(const fs::path& results, const fs::path& project,
                                const std::vector<Mark>& marks, int stage) {
    const fs::path folder = project / "steps" / name_of(stage);
    if (!has_trace(stage)) return {};
    const std::string projects = read_text(folder / "main.cpp");
    const std::string starter = read_text(folder / "starter/main.cpp");
    std::vector<LikeMain> all;
    for (const Mark& mark : marks) {
        if (mark.stage != stage || mark.trace_source.empty()) continue;
        const fs::path file =
            student_folder(results, mark.student) / "submitted" / submitted_name({stage, true});
        const int percent = percent_of_main(source_text(file), projects, starter);
        if (percent >= like_main_percent)
            all.push_back({.student = mark.student, .stage = stage, .percent = percent});
    }
    return all;
}

/// The strength of the evidence: the number of files, and the total.
std::pair<std::size_t, int> strength(const NearFiles& near) {
    int sum = 0;
    for (const auto& [file, percent] : near.percent) sum += percent;
    return {near.percent.size(), sum};
}

/// The student who stands for the group of this one.
std::string leader(const std::map<std::string, std::string>& next, const std::string& student) {
    const auto found = next.find(student);
    return found == next.end() ? student : leader(next, found->second);
}

}  // namespace

Similarity similarity(const fs::path& results, const fs::path& project,
                      const std::vector<Mark>& marks) {
    Similarity all;
    Pairs pairs;
    for (const auto& [stage, most] : graded_stages(marks)) {
        for (const GradedFile graded : files_of(stage)) {
            const std::vector<Text> texts = texts_of(results, project, marks, graded);
            for (SameFile& same : same_files(texts, graded)) all.same.push_back(std::move(same));
            compare_all(texts, graded, pairs);
        }
        for (LikeMain& each : like_main(results, project, marks, stage))
            all.like_main.push_back(std::move(each));
    }
    for (auto& [names, near] : pairs) all.near.push_back(std::move(near));
    std::ranges::stable_sort(all.near, std::greater(), strength);
    return all;
}

std::vector<NearGroup> groups(const std::vector<NearFiles>& near) {
    std::map<std::string, std::string> next;
    for (const NearFiles& pair : near) {
        const std::string one = leader(next, pair.one);
        const std::string other = leader(next, pair.other);
        if (one != other) next[other] = one;
    }
    std::vector<NearGroup> all;
    std::map<std::string, std::size_t> places;
    for (const NearFiles& pair : near) {
        const auto [place, is_new] = places.emplace(leader(next, pair.one), all.size());
        if (is_new) all.emplace_back();
        NearGroup& group = all[place->second];
        group.students.insert({pair.one, pair.other});
        for (const auto& [file, percent] : pair.percent) {
            auto& [least, most] =
                group.percent.emplace(file, std::pair(percent, percent)).first->second;
            least = std::min(least, percent);
            most = std::max(most, percent);
        }
    }
    return all;
}

}  // namespace rt::grade

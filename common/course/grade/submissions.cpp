#include "common/course/grade/submissions.hpp"

#include "common/stages.hpp"

#include <algorithm>

namespace rt::grade {

int Submission::points() const {
    int sum = 0;
    for (const auto& [stage, mark] : marks) sum += mark->points();
    return sum;
}

std::vector<Submission> submissions(const std::vector<Mark>& marks) {
    std::map<std::string, Submission> by_name;
    for (const Mark& mark : marks) {
        Submission& submission = by_name[mark.student];
        submission.student = mark.student;
        submission.marks[mark.stage] = &mark;
    }
    std::vector<Submission> all;
    for (auto& [name, submission] : by_name) all.push_back(std::move(submission));
    return all;
}

std::map<int, int> graded_stages(const std::vector<Mark>& marks) {
    std::map<int, int> stages;
    for (const Mark& mark : marks) {
        int& most = stages[mark.stage];
        most = std::max(most, mark.most);
    }
    return stages;
}

int most_points(const std::map<int, int>& stages) {
    int sum = 0;
    for (const auto& [stage, most] : stages) sum += most;
    return sum;
}

std::string stage_title(int stage) {
    std::string title(stage_name(stage).substr(std::string_view("step05_").size()));
    std::replace(title.begin(), title.end(), '_', ' ');
    return std::to_string(stage) + " " + title;
}

}  // namespace rt::grade

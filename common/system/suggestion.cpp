#include "common/system/suggestion.hpp"

#include "common/system/text.hpp"

#include <algorithm>
#include <numeric>

namespace rt {

std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> cost(a.size() + 1,
                                               std::vector<std::size_t>(b.size() + 1));
    std::iota(cost[0].begin(), cost[0].end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        cost[i][0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1,
                                   cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
        }
    }
    return cost[a.size()][b.size()];
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
    const std::string asked = lower_case(word);
    std::string best;
    std::size_t least = std::max(asked.size(), std::size_t{2}) / 3 + 1;  // too much
    for (const std::string& candidate : known) {
        const bool begins = asked.size() >= 3 && candidate.starts_with(asked);
        const std::size_t changes = begins ? 0 : edits(asked, candidate);
        if (changes >= least) continue;
        least = changes;
        best = candidate;
    }
    return best.empty() ? "" : " Did you mean " + best + "?";
}

}  // namespace rt

#include "base/cli/suggestion.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vantage {
namespace {

/// The edit distance between two words: the number of letters that must be inserted, deleted or replaced
/// (Levenshtein 1966).
std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& words) {
    const auto off = [&](const std::string& other) { return edits(word, other); };
    const auto nearest = std::ranges::min_element(words, {}, off);
    const bool like = nearest != words.end() && off(*nearest) <= (word.size() + 1) / 3;
    return like && !word.empty() ? "; did you mean " + *nearest + "?" : "";
}

}  // namespace vantage

#pragma once
#include <string>
#include <vector>

namespace vantage {

/// "; did you mean WORD?" if one of the words is similar, otherwise an empty string. Words are similar if at
/// most a third of the letters must be inserted, deleted or replaced (Levenshtein 1966).
std::string suggestion(const std::string& word, const std::vector<std::string>& words);

}  // namespace vantage

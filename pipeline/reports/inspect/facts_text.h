#pragma once
#include <string>

#include "pipeline/reports/inspect/input_facts.h"

namespace vantage {

/// The facts as labeled lines, for people. Long lists are truncated; facts_json() has all entries. The error
/// is not included, because the caller prints it.
std::string facts_text(const InputFacts& facts);

}  // namespace vantage

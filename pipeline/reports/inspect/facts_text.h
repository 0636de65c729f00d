#pragma once
#include <string>

#include "pipeline/reports/inspect/input_facts.h"

namespace vantage {

/// The facts for people, as labeled lines. Long lists are truncated; facts_json() has all entries. The caller
/// prints the error.
std::string facts_text(const InputFacts& facts);

}  // namespace vantage

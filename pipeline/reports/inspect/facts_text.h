#pragma once
#include <string>

#include "pipeline/reports/inspect/input_facts.h"

namespace vantage {

/// The facts for people: lines with a label each. Long lists are cut; facts_json() has all of them. The error
/// is left to the caller.
std::string facts_text(const InputFacts& facts);

}  // namespace vantage

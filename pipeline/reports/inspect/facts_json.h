#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/reports/inspect/input_facts.h"

namespace vantage {

/// The facts for programs; docs/inspect.md lists the keys, all of which are always present.
nlohmann::json facts_json(const InputFacts& facts);

}  // namespace vantage

#pragma once
#include <nlohmann/json_fwd.hpp>

#include "pipeline/reports/inspect/input_facts.h"

namespace vantage {

/// The facts as JSON, for programs. docs/inspect.md lists the keys; all of them are always present.
nlohmann::json facts_json(const InputFacts& facts);

}  // namespace vantage

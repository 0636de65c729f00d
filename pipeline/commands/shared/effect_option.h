#pragma once
#include <map>
#include <string>
#include <vector>

#include "base/cli/command.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// Adds --effect. `texts` receives its arguments, such as "exposure=off", for choose_effects().
void add_effects(const Command& command, std::vector<std::string>& texts);

/// Applies "NAME=on|off|auto" to `choices`. Throws Error(usage) for malformed strings and unknown effects.
void choose_effects(const std::vector<std::string>& texts, std::map<Effect, EffectChoice>& choices);

}  // namespace vantage

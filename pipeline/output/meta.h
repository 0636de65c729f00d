#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "pipeline/input/identity_cache.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/run/settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The program and its version, as stored in META.
inline constexpr const char* tool_name = "vantage " VANTAGE_VERSION;

/// The settings as stored in META.
nlohmann::json settings_json(const PrepareSettings& settings);

/// META, the package's provenance as JSON: tool, settings, inputs with length and checksum, effects with
/// their evidence, skipped photos, warnings, names of scalar fields. META is padded to leave space for
/// results that depend on all photos. Throws Error(input).
std::string make_meta(const SceneInput& scene, const PrepareSettings& settings,
                      const std::vector<EffectDecision>& effects, IdentityCache& identities);

/// META with the decisions of these effects replaced, and with findings (warnings about photos and cameras),
/// one line each. The length stays the same: findings that do not fit are only counted.
std::string with_results(const std::string& meta, std::span<const EffectDecision> decisions,
                         std::span<const std::string> findings);
/// META of the same package with its tiles compressed or raw; the length may differ.
std::string repacked_meta(const std::string& meta, bool compact);
/// META with different choices for its effects; the length stays the same.
std::string with_choices(const std::string& meta, const std::map<Effect, EffectChoice>& choices);

/// Parses a package's META. Throws Error(damaged).
nlohmann::json parse_meta(const PackageReader& package);
EffectDecision decision_in(const std::string& meta, Effect effect);
std::vector<std::string> findings_in(const std::string& meta);
/// The effects that were forced on or off.
std::map<Effect, EffectChoice> choices_in(const std::string& meta);
/// The settings that merge and refine need; all others have their defaults.
PrepareSettings scene_settings_in(const std::string& meta);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "pipeline/identity_cache.h"
#include "pipeline/prepare.h"
#include "scene/package_reader.h"

namespace vantage {

/// The settings as META names them.
nlohmann::json settings_json(const PrepareSettings& settings);

/// META: where the package comes from, as JSON: tool, settings, inputs with length and checksum, effects with
/// their evidence, what was left out at once, warnings, names of scalar layers. Throws Error(input).
std::string provenance(const SceneInput& scene, const PrepareSettings& settings,
                       const std::vector<EffectDecision>& effects, IdentityCache& identities);

/// META with these effects' rows instead of those it has, and what was found out last, a line each; as long
/// as before: it ends in room for them.
std::string with_findings(const std::string& meta, std::span<const EffectDecision> decisions,
                          std::span<const std::string> findings);
/// An effect as META tells it, and what was found out last.
EffectDecision decision_of(const std::string& meta, Effect effect);
std::vector<std::string> findings_of(const std::string& meta);

/// The effects that META's settings force.
std::map<Effect, EffectChoice> forced_effects(const std::string& meta);

/// The settings that the stages which look at the model read, as META names them.
PrepareSettings geometry_settings(const std::string& meta);

/// META with other effects forced, as long as before.
std::string with_forced(const std::string& meta, const std::map<Effect, EffectChoice>& choices);

/// What distinguishes a package from one that these inputs would give now, a line each: "mesh.ply: has
/// changed since the package was prepared". Nothing where it is current. Throws Error(damaged) for an
/// unreadable META.
std::vector<std::string> changed_inputs(const PackageReader& package, const InputFiles& files,
                                        IdentityCache& identities);
/// The same for the settings and the tool that it was prepared with.
std::vector<std::string> changed_settings(const PackageReader& package, const PrepareSettings& settings);

/// The photos that a package lacks: those without camera or file, and those that could not be decoded.
std::vector<UnusablePhoto> left_out_of(const PackageReader& package);

}  // namespace vantage

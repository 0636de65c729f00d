#pragma once
#include <string>
#include <vector>

#include "pipeline/input/identity_cache.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/settings/settings.h"
#include "scene/package_reader.h"

namespace vantage {

/// What has changed since the package was prepared from these inputs, one line each: "mesh.ply: has changed
/// since the package was prepared". Empty if it is current. Throws Error(damaged) for an unreadable META.
std::vector<std::string> changed_inputs(const PackageReader& package, const InputFiles& files,
                                        IdentityCache& identities);
/// The same for the settings and the version of the program.
std::vector<std::string> changed_settings(const PackageReader& package, const PrepareSettings& settings);

/// The photos that a package lacks: those without a camera or a file, and those that could not be decoded.
std::vector<UnusablePhoto> left_out_of(const PackageReader& package);

}  // namespace vantage

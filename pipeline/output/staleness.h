#pragma once
#include <string>
#include <vector>

#include "pipeline/input/identity_cache.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/run/settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A difference between an input of a package and the current file.
struct InputChange {
    enum class Kind { changed, added, missing };
    Kind kind;
    std::string text;  ///< "mesh.ply: has changed since the package was prepared"
};
/// The inputs that have changed since the package was prepared; empty if it is current. Reference meshes and
/// point clouds are compared only if listed in `files`. Throws Error(damaged) if META cannot be read.
std::vector<InputChange> changed_inputs(const PackageReader& package, const InputFiles& files,
                                        IdentityCache& identities);
/// The names of the files in a list of META's inputs ("compared", "points"), except
/// one with the mesh's name. Throws Error(damaged) if META cannot be read.
std::vector<std::string> names_listed(const PackageReader& package, const char* list);

/// The package's setting for image sets: auto, folders, off, or the name of a file. Throws Error(damaged) if
/// META cannot be read.
std::string image_sets_wanted(const PackageReader& package);

/// One line for each setting that differs from the package's, one for the program's version if it differs,
/// and one for each warning about a color profile that an earlier version did not convert.
std::vector<std::string> changed_settings(const PackageReader& package, const PrepareSettings& settings);

/// The first chunk or tile of the package that does not match its checksum, as a message; empty if there is
/// none. Reads the whole package, unless it was found valid before and has not been modified since.
std::string damage_of(const PackageReader& package, IdentityCache& identities);

/// The photos that a package lacks: those without a camera or file, and those that could not be decoded.
std::vector<UnusablePhoto> skipped_of(const PackageReader& package);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <string>

#include "pipeline/costs/costs.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A key that identifies a scan by the contents of its mesh, cameras and point clouds, regardless of their
/// paths. Throws Error(damaged).
std::string costs_key(const PackageReader& package);
/// The total size of the photo files, excluding held-out photos.
double photo_file_bytes(const PackageReader& package);

/// Reads a results file of `vantage costs`. Throws Error(input).
Costs read_costs(const std::filesystem::path& file);

/// Keeps the measurements of each scan in the user's cache, for known_costs(). Failures are ignored.
void keep_costs(const Costs& costs);

/// Measurements, and their origin.
struct KnownCosts {
    Costs costs;
    bool own = false;  ///< measured on this scan and this machine; otherwise shipped with the program
};
/// The measurements of the scan with this key or, if there are none, those shipped with the program. If there
/// are none either, `costs` has no scans.
KnownCosts known_costs(const std::string& key);

}  // namespace vantage

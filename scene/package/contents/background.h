#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// A backdrop around scene and cameras, for what photos show beside the mesh.
struct BackgroundContent {
    std::vector<Eigen::Vector3f> positions;               ///< relative to the origin
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of these; counterclockwise seen from inside
    std::vector<package::ClusterRecord> clusters;         ///< of these triangles, in order, all of them
    std::vector<std::array<std::uint8_t, 4>> colors;      ///< per vertex: sRGB where no photo shows it
    std::vector<std::vector<package::CoverageRecord>> coverage;  ///< per photo and cluster; may be empty
    std::vector<std::vector<std::uint64_t>> visible;             ///< per photo, as VISB; may be empty
};

/// The content of SURR, see FORMAT.md.
std::vector<std::byte> background_chunk(const BackgroundContent& content);

/// The package's background; nothing if it has none. Copied, because the file may be overwritten while it
/// is shown. Throws Error(damaged) if the chunk does not match its checksum or its own counts.
std::optional<BackgroundContent> read_background(const PackageReader& package);

}  // namespace vantage

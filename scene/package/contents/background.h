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

inline constexpr int max_background_labels = 31;
inline constexpr float background_trust = 7, correction_scale = 500;

/// A backdrop around the scene and the cameras that shows the photographed background.
struct BackgroundContent {
    std::vector<Eigen::Vector3f> positions;               ///< relative to the origin
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise as seen from inside
    std::vector<package::ClusterRecord> clusters;         ///< cover all these triangles, in order
    /// Per vertex: the background color (robust mean), sRGB; 8 times the label of the photo that shows it,
    /// plus the trust in that photo, 0 to 7.
    std::vector<std::array<std::uint8_t, 4>> colors;
    /// Per vertex: the correction of that photo's color, in square roots of light times `correction_scale`;
    /// the fourth value is 0.
    std::vector<std::array<std::int8_t, 4>> corrections;
    std::vector<std::uint32_t> hidden;  ///< hidden triangles of the mesh, where photos show sky
    std::vector<std::uint8_t> labels;   ///< per photo, 1 to 31; 0: used only near the photo's own view
    std::vector<std::vector<package::CoverageRecord>> coverage;  ///< per photo and cluster; may be empty
    std::vector<std::vector<std::uint64_t>> visible;  ///< per photo, in the form of VISB; may be empty
};

/// The content of the chunk SURR, see FORMAT.md.
std::vector<std::byte> background_chunk(const BackgroundContent& content);

/// The package's background; empty if it has none. The result is a copy, because the file may be overwritten
/// while it is shown. Throws Error(damaged) if the chunk does not match its checksum or its own counts.
std::optional<BackgroundContent> read_background(const PackageReader& package);

}  // namespace vantage

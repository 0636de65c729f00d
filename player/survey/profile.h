#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "player/plan/section_plane.h"
#include "player/survey/scene_point.h"
#include "player/survey/units.h"

namespace vantage {

/// The surface along the line between two points: its offsets from the line or, where it is nearly
/// horizontal, its heights. The surface point with the offset o at the distance s is at from + s * along + o
/// * across. Units are those of the scene; positions are relative to its origin.
struct SurfaceProfile {
    const char* reason = nullptr;  ///< the reason for an empty profile, see marked(); otherwise null
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), along = Eigen::Vector3d::UnitX(),
                    across = Eigen::Vector3d::UnitZ();  ///< the first point, and perpendicular unit vectors
    double length = 0, rise = 0;                        ///< distance and offset of the second point
    bool heights = false;  ///< `across` is up and distances are horizontal; otherwise `rise` is 0
    /// Offsets at equal distances from 0 to `length`; nullopt in gaps of the surface. Empty if
    /// `reason` is set.
    std::vector<std::optional<double>> offsets{};

    double distance(std::size_t i) const { return length * double(i) / double(offsets.size() - 1); }
    /// The surface point of offsets[i]; nullopt in gaps.
    std::optional<Eigen::Vector3d> point(std::size_t i) const;
};

/// The profile of the part of the surface that remains after the cuts of `sections`. The profile is in the
/// plane of the line and the surface's mean normal near its ends, which becomes vertical or horizontal if it
/// is within 20 degrees. Where the plane meets several surfaces, the profile shows the outermost one at most
/// half the line's length from the line. The photos that see the surface are outside. `up` is a unit vector.
SurfaceProfile profile_between(std::span<const PlacedMesh> meshes, std::span<const SectionPlane> sections,
                               const std::array<Eigen::Vector3d, 2>& points, const Eigen::Vector3d& up);

/// A table with one line per offset: distances and offsets in the displayed unit, and positions in input
/// coordinates, in which the scene's origin is `origin`.
std::string profile_csv(const SurfaceProfile& profile, const Scale& scale, const Eigen::Vector3d& origin);

}  // namespace vantage

#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace vantage {

enum class Material : std::uint8_t {
    brick,
    plaster,
    window,
    grating,
    text,
    roof,
    paving,
    marble,
    grass,
    trees,
    iron,
    ashlar,  // from here on, materials of a chapel and the country around it, see surface_finish.h
    limestone,
    statuary,
    wood,
    leads,
    tiles,
    flags,
    meadow
};

/// Diffuse reflectance (linear RGB, [0, 1]) of a material at a point, in meters, on a surface with this unit
/// normal. It has millimeter-sized details, which a baked texture would lose.
Eigen::Vector3f albedo(Material material, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

/// Diffuse reflectance in infrared, which is gray: details under plaster are visible, but ink and colors
/// hardly are. Plaster has an underdrawing of arches and squares in charcoal.
Eigen::Vector3f infrared_albedo(Material material, const Eigen::Vector3d& point,
                                const Eigen::Vector3d& normal);

/// The coordinates, across and up, of a point on a surface with this normal, or the coordinates in the ground
/// plane if |normal.z| exceeds `level`.
Eigen::Vector2d across_and_up(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double level);

/// Light from a cloudy sky at infinity; `direction` has length 1.
Eigen::Vector3f clouded(const Eigen::Vector3f& sky, const Eigen::Vector3d& direction);

}  // namespace vantage

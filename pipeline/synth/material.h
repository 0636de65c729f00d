#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace vantage {

enum class Material : std::uint8_t { brick, plaster, window, grating, text, roof, paving, marble };

/// Diffuse reflectance (linear, [0,1]) of a material at a point of the scene, in metres, with the surface's
/// unit normal. Fine detail down to millimetres: what a baked texture would lose.
Eigen::Vector3f albedo(Material material, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

}  // namespace vantage

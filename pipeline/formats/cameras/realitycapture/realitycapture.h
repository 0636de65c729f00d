#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera/lens.h"

namespace vantage {

/// The lens of one of RealityCapture's models, from k1 k2 k3 k4 t1 t2 and the skew in focal lengths; empty if
/// the model is not among realitycapture_models(). See "On the Coordinate Systems Employed in [...] Camera
/// Geometry by RealityScan" (2026): t1 and t2 are p2 and p1 of OpenCV.
std::optional<Lens> realitycapture_lens(std::string_view model, const std::array<double, 6>& coefficients,
                                        double skew);
std::string realitycapture_models();

/// Whether the file is an XMP sidecar of RealityCapture or RealityScan.
bool is_realitycapture_sidecar(const std::filesystem::path& file);
/// The sidecars in a folder and two levels below it, sorted.
std::vector<std::filesystem::path> realitycapture_sidecars(const std::filesystem::path& folder);

/// Whether the file is a list of cameras with named columns.
bool is_realitycapture_csv(const std::filesystem::path& file);

}  // namespace vantage

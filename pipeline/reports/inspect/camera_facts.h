#pragma once
#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/reports/inspect/range.h"

namespace vantage {

/// Cameras of one photo size and lens model.
struct LensFacts {
    std::size_t cameras = 0;
    std::size_t calibrations = 0;  ///< number of different combinations of intrinsics and lens
    int width = 0, height = 0;     ///< px; 0 if not in the camera file
    CameraSet::Unit unit{};        ///< unit of the focal lengths
    LensModel model{};
    Range focal_x{}, focal_y{};
    Range view_x{}, view_y{};  ///< fields of view in degrees; empty if they depend on the photo's size
    struct Coefficient {
        const char* name;
        Range value;
    };
    std::vector<Coefficient> coefficients{};  ///< coefficients that are nonzero for at least one camera
};

struct CameraFacts {
    std::size_t cameras = 0;        ///< in the files
    Eigen::AlignedBox3d centers;    ///< bounding box of the cameras' positions in input units
    std::vector<LensFacts> lenses;  ///< lenses with the most cameras first
};

/// Facts about these cameras. Non-finite numbers and focal lengths that are not positive are ignored.
CameraFacts camera_facts(std::span<const CameraSet::Entry> cameras);

/// The name of the unit: "px", "photo width" or "longer side".
const char* name(CameraSet::Unit unit);

/// The angle of view in degrees, including the lens: between the left and right edges of the frame (`axis` 0)
/// or the top and bottom edges (1), along the line through the principal point. If the valid range of the
/// lens ends inside the frame, the angle ends there, too. NaN if the size of the frame is unknown.
double field_of_view(const Camera& camera, int axis);

}  // namespace vantage

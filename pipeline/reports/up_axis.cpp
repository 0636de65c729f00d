#include "pipeline/reports/up_axis.h"

#include <cmath>
#include <vector>

#include "pipeline/surroundings/down_direction.h"
#include "scene/package_reader.h"

namespace vantage {
namespace {

/// Mean of the columns' parts along down below which the cameras were not held upright but look along it.
constexpr double least_upright = 0.2;

}  // namespace

UpAxis up_axis(std::span<const package::PhotoRecord> photos) {
    if (photos.empty()) return {};
    std::vector<Pose> poses;
    Eigen::Vector3d columns = Eigen::Vector3d::Zero(), directions = columns;
    for (const package::PhotoRecord& p : photos) {
        poses.push_back(cam_from_origin(p));
        columns += poses.back().R.row(1).transpose();
        directions += poses.back().direction();
    }
    int axis = 0;
    down_direction(poses).cwiseAbs().maxCoeff(&axis);
    const bool upright = std::abs(columns[axis]) > least_upright * double(photos.size());
    const double down = upright ? columns[axis] : directions[axis];
    return {axis, down > 0 ? -1 : 1};
}

}  // namespace vantage

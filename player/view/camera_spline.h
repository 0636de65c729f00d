#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "player/view/navigation.h"

namespace vantage {

/// A view on a flight, and its time in seconds.
struct KeyView {
    Navigation camera;
    double seconds = 0;
};

/// A smooth flight through key views. The camera's rotation, its target and the logarithm of its distance
/// follow cubic curves with continuous velocity: between views of an object, the camera flies around the
/// object, not through it. It starts and ends at rest, and does not move between two equal keys. Two keys at
/// the same time make a cut. If all keys are level, every view between them is level too.
class CameraSpline {
  public:
    /// `keys`: at least one, in order of time. Each target is moved onto the camera's axis.
    explicit CameraSpline(std::span<const KeyView> keys);

    /// The time of the last key.
    double seconds() const { return knots_.back().seconds; }
    /// Times are clamped to those of the first and last key.
    Navigation at(double seconds) const;

  private:
    static constexpr int dimensions = 9;
    using Place = Eigen::Matrix<double, dimensions, 1>;  ///< the source file names the components
    struct Knot {
        double seconds;
        Place place, speed;  ///< speed: per second
    };
    Navigation camera_at(const Place& place) const;

    std::vector<Knot> knots_;
    Eigen::Vector3d up_;
    bool level_;
};

}  // namespace vantage

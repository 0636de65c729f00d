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

/// A smooth flight through key views. The camera's rotation, its target and its distance (logarithmic) follow
/// cubic curves with continuous velocity: between views of an object it flies around it, not through it. It
/// starts and ends at rest, and between two equal keys it does not move. Two keys at the same time are a cut.
/// If all keys are level, so is every view between them.
class CameraSpline {
  public:
    /// `keys`: at least one, in order of time. Each target is moved onto the camera's axis.
    explicit CameraSpline(std::span<const KeyView> keys);

    /// Time of the last key.
    double seconds() const { return knots_.back().seconds; }
    /// Clamped to the first and last key.
    Navigation at(double seconds) const;

  private:
    static constexpr int dimensions = 9;
    using Place = Eigen::Matrix<double, dimensions, 1>;  ///< components are named in the source
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

#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "player/view/navigation.h"

namespace vantage {

/// A view that a flight meets, and when, in seconds.
struct KeyView {
    Navigation camera;
    double seconds = 0;
};

/// A smooth flight through key views. The camera turns, its target moves and its distance from it changes
/// (by factors) along cubic curves whose speeds are continuous: from a view of an object to another it flies
/// around it, not through it. It starts and ends at rest, and between two equal keys it stands still. Two
/// keys at the same time are a cut. If all keys are level, so is every view between them.
class CameraSpline {
  public:
    /// `keys`: at least one, their times in order. Each looks along its axis; its target is moved there.
    explicit CameraSpline(std::span<const KeyView> keys);

    /// When the last key is reached.
    double seconds() const { return knots_.back().seconds; }
    /// Before the first key, that one; after the last, that one.
    Navigation at(double seconds) const;

  private:
    static constexpr int dimensions = 9;
    using Place = Eigen::Matrix<double, dimensions, 1>;  ///< its parts are named in the source
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

#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "pipeline/background/coarse_view.h"

namespace vantage {

/// The photometric cost of a point on the backdrop; see docs/method.md. Points are given by a direction from
/// the center and an inverse distance.
class PlaceCost {
  public:
    /// `center` is relative to the origin. Keeps references to the views.
    PlaceCost(std::span<const CoarseView> views, const Eigen::Vector3d& center);

    /// Maximum difference between one photo and the others, in ln(color)
    static constexpr float largest = 0.5f;

    /// A view that may show points in a direction; in its camera space, such a point is (center * inverse +
    /// ray) times its distance.
    struct Sight {
        const CoarseView* view;
        Eigen::Vector3f center, ray;
    };
    using Sights = std::vector<Sight>;
    /// The views that may show points at inverse distances from `low` to `high`.
    void aim(const Eigen::Vector3f& direction, float low, float high, Sights& out) const;

    float operator()(const Sights& sights, float inverse) const;
    /// Whether any photo shows the point.
    bool is_shown(const Sights& sights, float inverse) const;
    /// The largest inverse distance at which no camera is behind the backdrop.
    float innermost(const Eigen::Vector3f& direction) const;

  private:
    struct SweptView {
        const CoarseView& view;
        Eigen::Matrix3f R;
        Eigen::Vector3f center;  ///< in camera space
        /// The product of this matrix and a point inside the photo has only positive elements.
        Eigen::Matrix<float, 5, 3> frame;
    };
    std::vector<SweptView> views_;
    std::vector<Eigen::Vector3f> eyes_;  ///< relative to the center
};

}  // namespace vantage

#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "pipeline/background/coarse_view.h"

namespace vantage {

/// How much photos speak against a place of the backdrop, see docs/method.md. Places are given by a direction
/// from the center and an inverse distance.
class PlaceCost {
  public:
    /// `center` relative to the origin; keeps references to the views.
    PlaceCost(std::span<const CoarseView> views, const Eigen::Vector3d& center);

    static constexpr float largest = 0.5f;  ///< of one photo's difference from the others, in ln(color)

    /// A view that some of a direction's places may be in; in its camera space, a place is
    /// center * inverse + ray, times its distance.
    struct Sight {
        const CoarseView* view;
        Eigen::Vector3f center, ray;
    };
    using Sights = std::vector<Sight>;
    /// The views that places from `low` to `high`, inverse distances, may be in.
    void aim(const Eigen::Vector3f& direction, float low, float high, Sights& out) const;

    float operator()(const Sights& sights, float inverse) const;
    /// Whether the place is in a photo.
    bool is_shown(const Sights& sights, float inverse) const;
    /// The largest inverse distance at which no camera is behind the backdrop.
    float innermost(const Eigen::Vector3f& direction) const;

  private:
    struct SweptView {
        const CoarseView& view;
        Eigen::Matrix3f R;
        Eigen::Vector3f center;            ///< in camera space
        Eigen::Matrix<float, 5, 3> frame;  ///< times a place: all positive inside the photo
    };
    std::vector<SweptView> views_;
    std::vector<Eigen::Vector3f> eyes_;  ///< relative to the center
};

}  // namespace vantage

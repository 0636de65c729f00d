#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/refine/poses/match_view.h"

namespace vantage {

/// The match of a corner in another photo.
struct Match {
    std::uint32_t photo;
    Eigen::Vector2d pixel;  ///< full-size pixels of that photo
    Eigen::Vector2d moved;  ///< offset from the prediction, in full-size pixels of the track's photo
};

/// A corner in a photo, its point on the surface, and its matches in other photos.
struct Track {
    std::uint32_t photo;
    Eigen::Vector2d pixel;          ///< full size
    Eigen::Vector3d point, normal;  ///< relative to the origin; the normal has unit length
    std::vector<Match> matches;
};

/// A photo and its visible surface, onto which other photos are warped for matching. `view` must outlive this
/// object.
class SurfaceChart {
  public:
    /// Finds up to `corners` corners (Shi and Tomasi 1994), at least 16 pixels of the level apart. `pose`:
    /// the current estimate of the camera's pose; the surface is still the one seen from `view.pose`.
    SurfaceChart(const MatchView& view, const Pose& pose, std::uint32_t photo, int corners);

    const std::vector<Track>& tracks() const { return tracks_; }
    /// Finds the corners in another photo (pyramidal Lucas and Kanade 1981) and adds the matches to the
    /// corners' tracks. A match must return to within 0.75 px of the corner when tracked back, have a
    /// correlation of at least 0.75, and lie on a smooth surface. Returns the number of corners that could be
    /// compared.
    std::size_t match(const MatchView& other, const Pose& other_pose, std::uint32_t other_photo);

  private:
    /// The surface point at a pixel, with interpolated depth, relative to the origin.
    Eigen::Vector3d surface_point(const Eigen::Vector2d& pixel) const;
    /// Whether the pixel's neighborhood is inside the photo and on one surface.
    bool is_smooth(const Eigen::Vector2d& pixel) const;

    const MatchView& view_;
    Pose pose_;
    cv::Mat gray_;
    std::vector<cv::Mat> pyramid_;  ///< of `gray_`
    std::vector<cv::Point2f> corners_;
    std::vector<Track> tracks_;
};

}  // namespace vantage

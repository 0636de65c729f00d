#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/agree/match_view.h"

namespace vantage {

/// Where another photo shows a corner of this one.
struct Match {
    std::uint32_t photo;
    Eigen::Vector2d pixel;  ///< full-size pixels of that photo
    Eigen::Vector2d moved;  ///< away from where the cameras expect it, in this photo's full-size pixels
};

/// A corner of a photo, on the surface, and where other photos show it.
struct Track {
    std::uint32_t photo;
    Eigen::Vector2d pixel;          ///< full size
    Eigen::Vector3d point, normal;  ///< relative to the origin; unit
    std::vector<Match> matches;
};

/// A photo's surface, and the photo drawn onto it: what others are matched with.
class SurfaceChart {
  public:
    /// `pose`: what is now thought of the camera; the surface stays what `view` saw. At most `corners` are
    /// looked for, one a block of 16 pixels.
    SurfaceChart(const MatchView& view, const Pose& pose, std::uint32_t photo, int corners);

    const std::vector<Track>& tracks() const { return tracks_; }
    /// How many corners could be compared, and adds those that were found again to their tracks: displaced
    /// there and back by the same (to 3/4 of a pixel), alike (correlation above 0.75), on one smooth surface.
    std::size_t match(const MatchView& other, const Pose& other_pose, std::uint32_t other_photo);

  private:
    Eigen::Vector3d lifted(const Eigen::Vector2d& pixel) const;
    bool smooth(const Eigen::Vector2d& pixel) const;

    const MatchView& view_;
    Pose pose_;
    cv::Mat grey_;
    std::vector<cv::Point2f> corners_;
    std::vector<Track> tracks_;
};

}  // namespace vantage

#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/survey/profile.h"
#include "player/survey/survey.h"
#include "player/view/view.h"

namespace vantage {

/// The profile of the selected measurement, as a chart and as a line on the model.
class ProfileChart {
  public:
    /// `origin`: the scene's origin in input coordinates.
    explicit ProfileChart(const Eigen::Vector3d& origin) : origin_(origin) {}

    /// Draws the chart and its controls if a profile is selected. Recomputes the profile if its points, the
    /// cuts or the meshes have changed.
    void show(Controls& controls, Session& session, std::span<const PlacedMesh> meshes, const Survey& survey,
              std::optional<std::size_t> selected);
    /// Draws the profile shown last and the position under the pointer over the picture, without occlusion.
    void draw(const View& view) const;

  private:
    void update(const Session& session, std::span<const PlacedMesh> meshes,
                const std::vector<SurveyPoint>& points, const Eigen::Vector3d& up);
    void chart(Controls& controls, const Scale& scale);
    void caption(Controls& controls, const Measurement& measurement, const Survey& survey) const;

    Eigen::Vector3d origin_;
    // The profile, and what it was computed from.
    SurfaceProfile profile_;
    std::vector<SurveyPoint> points_;
    std::vector<SectionPlane> sections_;
    std::vector<PlacedMesh> meshes_;
    std::optional<std::size_t> hovered_;  ///< index of the offset under the pointer
    double vertical_scale_ = 1;           ///< of offsets in the chart
};

}  // namespace vantage

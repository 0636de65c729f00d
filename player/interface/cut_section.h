#pragma once
#include <vector>

#include "player/interface/controls.h"
#include "player/interface/session.h"
#include "player/survey/section.h"

namespace vantage {

/// The plane that the session cuts the model with; nothing if it does not.
std::optional<SectionPlane> section_of(const Cut& cut, const PlanScene& scene);

/// The section of the sidebar: where the model is cut.
void cut_section(Controls& controls, Session& session, const PlanScene& scene, const Eigen::Vector3d& origin);

/// The lines of the cut over the picture.
class CutLines {
  public:
    /// Draws them over `view`; finds them again if the plane or the meshes have changed.
    void show(std::span<const PlacedMesh> meshes, const std::optional<SectionPlane>& plane, const View& view);
    const std::vector<SectionLine>& lines() const { return lines_; }

  private:
    std::optional<SectionPlane> plane_;
    std::size_t meshes_ = 0;
    std::vector<SectionLine> lines_;
};

}  // namespace vantage

#pragma once
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/survey/section.h"

namespace vantage {

/// The session's section planes: none, one, or those of a box.
std::vector<SectionPlane> sections_of(Cut& cut, const PlanScene& scene);

/// The sidebar's section for cutting the model.
void cut_section(Controls& controls, Session& session, const PlanScene& scene, const Eigen::Vector3d& origin);

/// The cut's outlines over the picture.
class CutLines {
  public:
    /// Draws the outlines over `view`, with the edges of a box. Recomputes the outlines if the planes or the
    /// meshes have changed.
    void show(std::span<const PlacedMesh> meshes, std::span<const SectionPlane> planes, const View& view);

  private:
    std::vector<SectionPlane> planes_;
    std::size_t meshes_ = 0;
    std::vector<SectionLine> lines_;
};

}  // namespace vantage

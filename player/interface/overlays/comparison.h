#pragma once
#include <cstdint>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/plan/plan_scene.h"
#include "player/plan/views/seen_triangles.h"

namespace vantage {

/// Labels of a comparison's two sides, and the swipe's draggable line. `frame`: the whole window, in pixels.
void comparison(Controls& controls, Session& session, const PlanScene& scene, const Area& frame);

/// Flies to the photo that agrees best with the view and compares the model with it, or ends a comparison in
/// progress.
void toggle_comparison(Session& session, const PlanScene& scene, const View& view, double now);

/// Ends a comparison when the camera has left the photo's: the photo would no longer match the model.
void end_comparison_off_photo(Session& session, const PlanScene& scene, double now);

/// Legend of the picture's false colors.
void false_color_legend(Controls& controls, const Session& session, const PlanScene& scene);

/// A line that says that no photo shows the gray or blurred surface, while it takes a notable part of the
/// picture.
class UnseenLegend {
  public:
    /// `seen`: the triangles in the picture.
    void show(Controls& controls, const Session& session, const PlanScene& scene, const SeenTriangles& seen);

  private:
    std::uint64_t version_ = 0;  ///< of the triangles
    std::vector<std::uint32_t> photos_;
    bool notable_ = false;
};

}  // namespace vantage

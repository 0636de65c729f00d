#pragma once
#include <optional>

#include "player/interface/state/window_state.h"
#include "player/render/render_settings.h"
#include "player/view/view.h"

namespace vantage {

/// Areas of the interface's parts in the window, in pixels. Hidden parts have no size.
struct Layout {
    Area menu, sidebar, strip, bar;
    Area free;  ///< remaining area for the picture, without a column for the measure panel if there is room
};

/// `em`: text height in pixels. `photos`: whether the scene has photos for the strip.
Layout layout_of(const Panels& panels, int width, int height, double em, bool photos);

/// The area that the picture is fitted to. Panels that open or close lie over the picture, which stays as it
/// is, so that it need not be drawn again. The next flight centers the view in the area that they leave free.
class PictureArea {
  public:
    /// The area in a frame of this size at `now` seconds. `flight_end`: the end of the flight in progress or
    /// that has just ended, in seconds.
    Area update(const Layout& layout, Compare compare, FrameSize size, std::optional<double> flight_end,
                double now);

  private:
    Area area_, aim_;
    FrameSize size_{};
    bool side_by_side_ = false, flies_ = false;
    double updated_ = 0, arrives_ = 0;  ///< seconds
};

}  // namespace vantage

#pragma once
#include "player/interface/state/window_state.h"
#include "player/render/render_settings.h"
#include "player/view/view.h"

namespace vantage {

/// Areas of the interface's parts in the window, in pixels. Hidden parts have no size.
struct Layout {
    Area menu, sidebar, strip, bar;
    Area free;  ///< remaining area for the picture
};

/// `em`: text height in pixels. `photos`: whether the scene has photos for the strip.
Layout layout_of(const Panels& panels, int width, int height, double em, bool photos);

/// The part of the free area that the picture is fitted to: half of the area's width for side-by-side
/// comparison.
Area picture_area(const Layout& layout, Compare compare, int width);

}  // namespace vantage

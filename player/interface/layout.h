#pragma once
#include "player/interface/state/window_state.h"
#include "player/render/render_settings.h"
#include "player/view/view.h"

namespace vantage {

/// Where the parts of the interface are in the window, in pixels. A part that is not shown has no size.
struct Layout {
    Area menu, sidebar, strip, bar;
    Area free;  ///< what they leave to the picture
};

/// `em`: height of the text, pixels. `photos`: whether there are any for the strip.
Layout layout_of(const Panels& panels, int width, int height, double em, bool photos);

/// The part of the free area that the picture is fitted to: side by side, it is shown in half of the width.
Area picture_area(const Layout& layout, Compare compare, int width);

}  // namespace vantage

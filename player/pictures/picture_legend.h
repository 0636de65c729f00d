#pragma once
#include <optional>

#include "player/panels/picture_text.h"
#include "player/render/picture.h"
#include "player/render/render_settings.h"

namespace vantage {

/// Legends of scalar fields in pictures. The font is made for the first picture of each height.
class PictureLegend {
  public:
    /// Draws into the lower left corner of a picture: name, unit if known, color map with its isolines, and
    /// the values at its ends and center. Returns false, and draws nothing, if the legend would occupy more
    /// than half of the width or a third of the height.
    bool draw(Picture& picture, const ScalarField& field, const FieldSettings& settings);

  private:
    std::optional<PictureText> text_;
};

}  // namespace vantage

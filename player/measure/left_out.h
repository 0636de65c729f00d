#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "player/measure/change.h"
#include "player/render/renderer.h"

namespace vantage {

/// One photo beside the picture that the others make from its camera.
struct LeftOut {
    std::uint32_t photo = 0;
    std::string name;     ///< without extension
    PictureScore score;   ///< of the coloured pixels
    double coloured = 0;  ///< share of the photo's pixels with a surface behind them
    double over_nearest =
        0;  ///< dB, gains fitted, more than the nearest photo alone, where both show something
    std::array<double, 2> shift{0, 0};  ///< photo pixels at full size, see shift_of
    double stops = 0;                   ///< log2 of the photo's brightness over the picture's
    std::vector<std::string> remarks;   ///< what is wrong with it, in words
    std::optional<Change> change;       ///< since an earlier evaluation of the same photo
};

/// What photos say of a part of the model.
struct RegionError {
    std::size_t pixels = 0, uncoloured = 0;
    double squares = 0;  ///< of differences after gains, over three channels
    double rms() const;  ///< grey levels of 255; 0 where nothing is coloured
};

struct LeftOutPictures {
    Picture photo, rendered, difference;
    std::vector<bool> scored;  ///< pixels that both photo and rendered picture show
};

/// Compares a photo with what the others (`photos` without it) make of its view, at a pyramid level, 2x2
/// samples a pixel; adds to the errors of clusters.
LeftOut leave_out(Renderer& renderer, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                  std::uint32_t photo, int level, std::vector<RegionError>& regions,
                  LeftOutPictures& pictures);

/// Says of each what is wrong with it, beside the others.
void remark(std::vector<LeftOut>& results);

}  // namespace vantage

#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "player/measure/evaluation/change.h"
#include "player/measure/evaluation/relative_brightness.h"
#include "player/measure/evaluation/worst_regions.h"
#include "player/measure/whole_frame.h"
#include "player/render/renderer.h"

namespace vantage {

/// A photo compared with its view rendered from the other photos.
struct PhotoEvaluation {
    std::uint32_t photo = 0;
    std::string name;                ///< without extension
    PictureScore score;              ///< over the colored pixels
    FrameScore frame;                ///< over all pixels, as shown in the window
    CauseSquares causes{};           ///< the frame's squared error after gains
    std::vector<WorstRegion> worst;  ///< at most four, with different causes
    double colored = 0;              ///< fraction of the photo's surface pixels that have a color
    double over_nearest = 0;         ///< PSNR gain over the nearest photo alone, dB, where both have a color
    std::array<double, 2> shift{0, 0};  ///< photo pixels at full size, see shift_of
    RelativeBrightness brightness;      ///< of the photo
    std::vector<std::string> remarks;   ///< likely problems
    std::optional<Change> change;       ///< change since an earlier evaluation of this photo
};

/// The error of the pictures on a part of the model.
struct RegionError {
    std::size_t pixels = 0, uncolored = 0;
    double squares = 0;  ///< sum of squared differences after gains, over three channels
    double rms() const;  ///< gray levels, 0 to 255; 0 without colored pixels
};

struct EvaluationPictures {
    Picture photo, rendered, difference;
    Picture shown;               ///< the whole frame from as_in_window, with gains applied
    Picture causes;              ///< see cause_picture
    std::vector<Picture> alone;  ///< from single photos, after gains: the nearest, then those that agree best
    std::vector<Picture> worst;  ///< pictures of PhotoEvaluation::worst, see region_picture
    std::vector<bool> scored;    ///< per pixel: visible in the photo and colored in the rendered picture
};

/// A photo to hold out.
struct HeldOut {
    std::uint32_t photo;
    int level;                                      ///< pyramid level of the comparison
    std::span<const std::uint32_t> photos;          ///< all photos but this one
    std::span<const package::PhotoRecord> records;  ///< see ColorsWithout
};

/// Compares a photo with its view rendered from the others, with 2x2 samples per pixel. Adds the errors to
/// `regions`, one per cluster.
PhotoEvaluation evaluate_held_out(Renderer& renderer, RenderSettings settings, const HeldOut& held_out,
                                  std::vector<RegionError>& regions, EvaluationPictures& pictures);

/// Adds remarks about likely problems to the results of the photos. All results are needed to find SSIMs that
/// are unusually low.
void remark(std::vector<PhotoEvaluation>& results);

}  // namespace vantage

#pragma once
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "player/render/renderer.h"
#include "tests/bench/results/measurement.h"
#include "tests/bench/scenes/scene.h"

namespace vantage::bench {

/// A point of a curve that is measured by the pictures it gives.
struct PictureSetting {
    std::string curve, setting;
    bool exact = false, chosen = false;
    RenderSettings settings;
    int side = 2;              ///< samples along a pixel's side, in pictures that are compared with the truth
    bool timed_whole = false;  ///< a frame takes all of the samples, else one
    bool timed = true;         ///< frames are; else it is known that they take no other time
    double photos = 1;         ///< share of those that may be blended, evenly spread
    std::map<std::string, double> known{};  ///< metrics that come with the setting
};

/// How far a scene's views are from the truth where that is seeable; means over the views.
struct PictureErrors {
    double psnr = 0, ssim = 0, worst = 0;  ///< as PictureScore, after gains
    double uncoloured = 0;                 ///< per cent of what is seeable
};
PictureErrors picture_errors(std::span<const TrueView> views, std::span<const Picture> pictures);

/// All of a scene's views with these settings.
std::vector<Picture> render_views(Renderer& renderer, const BenchScene& scene, const PictureSetting& setting);

/// Draws frames of the view until one misses nothing.
void settle(Renderer& renderer, const TrueView& view, const PictureSetting& setting);

/// Milliseconds of a frame that stands still, everything resident; of all its samples where they are timed.
double time_frame(Renderer& renderer, const TrueView& view, const PictureSetting& setting);

/// Of a package of the scene: psnr, ssim, worst, uncoloured, photos and frame_ms of each, and psnr_exact:
/// beside the exact setting of the same curve, or else of another, where there is one. Keeps parts of
/// pictures where the worst differs most from the exact.
std::vector<Measurement> measure_pictures(const std::filesystem::path& package, const BenchScene& scene,
                                          const Effort& effort, std::span<const PictureSetting> settings,
                                          const std::filesystem::path& folder, const std::string& tag);

/// Enough for all that a package has.
MemoryBudget ample_memory();

}  // namespace vantage::bench

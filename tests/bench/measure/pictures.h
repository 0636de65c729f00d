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

/// A point on a curve that is measured by rendering pictures.
struct PictureSetting {
    std::string curve, setting;
    bool exact = false, chosen = false;
    RenderSettings settings;
    int side = 2;              ///< samples along a pixel's side in pictures that are compared with the truth
    bool timed_whole = false;  ///< measure the time of a frame with all samples instead of one sample
    bool timed = true;         ///< measure frame times; set to false if they are known not to differ
    std::map<std::string, double> known{};  ///< metrics given by the setting itself
    RenderTrials trials{};
};

/// The mean errors of a scene's views compared with the truth, over visible pixels.
struct PictureErrors {
    double psnr = 0, ssim = 0, worst = 0;  ///< measured as in PictureScore, after applying gains
    double uncolored = 0;                  ///< percent of the visible pixels
};
PictureErrors picture_errors(std::span<const TrueView> views, std::span<const Picture> pictures);

/// Renders all views of a scene with the given setting.
std::vector<Picture> render_views(Renderer& renderer, const BenchScene& scene, const PictureSetting& setting);

/// Draws up to 1000 frames of the view, until a frame has all its tiles.
void settle(Renderer& renderer, const TrueView& view, const PictureSetting& setting);

/// The time per frame, in milliseconds, of a still view with everything resident; includes all samples if
/// `timed_whole` is set.
double time_frame(Renderer& renderer, const TrueView& view, const PictureSetting& setting);

/// Measures each setting on a package of the scene: psnr, ssim, worst, uncoloured, photos, frame_ms
/// and psnr_exact. psnr_exact compares with the exact setting of the same curve, or of another
/// curve if the same curve has no exact setting. Exhibits show the window in which the worst setting differs
/// most from the exact one.
std::vector<Measurement> measure_pictures(const std::filesystem::path& package, const BenchScene& scene,
                                          const Effort& effort, std::span<const PictureSetting> settings,
                                          const std::filesystem::path& folder, const std::string& tag);

/// A memory budget large enough for whole packages.
MemoryBudget ample_memory();

}  // namespace vantage::bench

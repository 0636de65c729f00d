// Measures the sampling of a photo's pixels: filtering between levels and on slanted surfaces, sharpness, and
// samples per pixel.
#include <fmt/format.h>

#include "tests/bench/measure/pictures.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

PictureSetting setting(std::string curve, std::string name, int side) {
    PictureSetting s{std::move(curve), std::move(name), false, false, {}};
    s.settings.photos = window_photos;
    s.side = side;
    s.timed_whole = true;
    return s;
}

/// The exact setting has `most` samples along each side of a pixel.
std::vector<PictureSetting> settings(int most) {
    std::vector<PictureSetting> out{setting("samples", fmt::format("{0}x{0}", most), most)};
    out.back().exact = true;
    for (int side = 3; side >= 1; --side) {
        out.push_back(setting("samples", fmt::format("{0}x{0}", side), side));
        out.back().chosen = side == 2;
    }
    out.push_back(setting("one sample", "bilinear", 1));
    out.back().trials.trilinear = false;
    for (const int taps : {2, 4, 8, 16}) {
        out.push_back(setting("one sample", fmt::format("{} taps", taps), 1));
        out.back().trials.anisotropy = taps;
    }
    for (const double bias : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        out.push_back(setting("one sample, bias", fmt::format("{:g}", bias), 1));
        out.back().settings.lod_bias = bias;
    }
    return out;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort,
                                 const std::filesystem::path& folder) {
    return measure_pictures(scene.package, scene, effort, settings(effort.name == "smoke" ? 4 : 6), folder,
                            "filtering");
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    return {{"pictures", [=, &scene] { return measure(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep filtering_sweep;
const Sweep filtering_sweep{
    "filtering",
    "Filtering of photos",
    "One sample per pixel shimmers and blurs, and four cost four times as much. What can anisotropic taps "
    "and level biases save?",
    "the held-out photo, or the ray-cast picture; also against 36 samples per pixel (smoke: 16)",
    "exact by definition, because it is the picture with the most samples",
    {{"frame_ms", "psnr_exact"}, {"frame_ms", "psnr"}},
    jobs};

}  // namespace vantage::bench

// How a photo's pixels are read: between levels, along slanted surfaces, how sharply, how many samples a
// pixel.
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

/// `most` samples along a pixel's side stand for all.
std::vector<PictureSetting> settings(int most) {
    std::vector<PictureSetting> out{setting("samples", fmt::format("{0}x{0}", most), most)};
    out.back().exact = true;
    for (int side = 3; side >= 1; --side) {
        out.push_back(setting("samples", fmt::format("{0}x{0}", side), side));
        out.back().chosen = side == 2;
    }
    out.push_back(setting("one sample", "bilinear", 1));
    out.back().settings.trilinear = false;
    for (const int taps : {2, 4, 8, 16}) {
        out.push_back(setting("one sample", fmt::format("{} taps", taps), 1));
        out.back().settings.anisotropy = taps;
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
    "How a photo's pixels are read",
    "A sample a pixel shimmers and blurs; four cost four times as much. What do taps and biases save?",
    "the photo left out, or the ray-cast picture; beside it, 64 samples a pixel",
    "the picture of the most samples itself",
    {{"frame_ms", "psnr_exact"}, {"frame_ms", "psnr"}},
    jobs};

}  // namespace vantage::bench

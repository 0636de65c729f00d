// Measures the gain of the photographed background over the whole frame, and its cost.
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/prepared.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

namespace fs = std::filesystem;

/// The photos used as truth must be held out, because all photos contribute to the background.
std::vector<std::string> options(const BenchScene& scene, const std::string& choice) {
    std::vector<std::string> out{"--effect", "background=" + choice};
    std::string names;
    for (const TrueView& v : scene.views)
        if (!v.held_out.empty()) names += (names.empty() ? "" : ",") + v.held_out;
    if (!names.empty()) out.insert(out.end(), {"--hold-out", names});
    return out;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    std::vector<Measurement> out;
    for (const std::string choice : {"off", "on"}) {
        PictureSetting s{"background", choice, choice == "on", choice == "on", {}};
        s.settings.photos = window_photos;
        s.settings.fill_holes = true;
        s.whole_frame = true;
        out.push_back(
            measure_prepared(scene, effort, options(scene, choice), s, folder, "background-" + choice));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    return {{"both", [=, &scene] { return measure(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep background_sweep;
const Sweep background_sweep{
    "background",
    "Background",
    "How much closer to the photo is the whole frame if the photographed background is shown, and what does "
    "that cost in preparation time, bytes and frame time?",
    "the held-out photo, which is not in the package, or the ray-cast picture",
    "not applicable, because the background is an estimate",
    {{"prepare_s", "psnr_frame"}, {"package_bytes", "psnr_frame"}, {"frame_ms", "psnr_frame"}},
    jobs};

}  // namespace vantage::bench

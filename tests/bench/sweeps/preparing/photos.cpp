// Measures the gain from more photos, and from photos with more pixels.
#include <fmt/format.h>

#include <algorithm>

#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/prepared.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

namespace fs = std::filesystem;

std::vector<Measurement> measure_counts(const BenchScene& scene, const Effort& effort,
                                        const fs::path& folder) {
    const std::size_t all = scene.views.front().photos.size();
    std::vector<PictureSetting> settings;
    for (const double share : {1.0, 0.75, 0.5, 0.25, 0.125}) {
        const auto photos = std::lround(share * double(all));
        if (photos < 1 || (!settings.empty() && settings.back().setting == std::to_string(photos))) continue;
        PictureSetting s{"photos taken", fmt::format("{}", photos), share == 1, share == 1, {}};
        s.photos = share;
        settings.push_back(s);
    }
    std::vector<Measurement> out = measure_pictures(scene.package, scene, effort, settings, folder, "photos");
    const double bytes = double(fs::file_size(scene.package));
    for (std::size_t i = 0; i < out.size(); ++i) out[i].values["package_bytes"] = bytes * settings[i].photos;
    return out;
}

/// Packages are prepared from downscaled photos, and all photos are blended.
std::vector<Measurement> measure_resolutions(const BenchScene& scene, const Effort& effort,
                                             const fs::path& folder) {
    std::uint32_t longest = 0;
    double pixels = 0;
    const PackageReader whole(scene.package);
    for (const package::PhotoRecord& p : whole.photos()) {
        longest = std::max({longest, p.width, p.height});
        pixels = std::max(pixels, 1e-6 * p.width * p.height);
    }
    std::vector<Measurement> out;
    for (const int divisor : {1, 2, 4, 8}) {
        const std::string size = std::to_string(std::max(16u, longest / std::uint32_t(divisor)));
        const PictureSetting one{"pixels per photo", size + " px", divisor == 1, divisor == 1, {}};
        out.push_back(measure_prepared(scene, effort, {"--max-photo-size", size}, one, folder,
                                       fmt::format("pixels-{}", divisor)));
        out.back().values["pixels"] = pixels / (divisor * divisor);
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    return {{"count", [=, &scene] { return measure_counts(scene, effort, folder); }},
            {"resolution", [=, &scene] { return measure_resolutions(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep photos_sweep;
const Sweep photos_sweep{
    "photos",
    "Number and resolution of photos",
    "How much would be gained by more photos, or by photos with more pixels?",
    "the held-out photo, or the ray-cast picture",
    "not applicable, because no setting is exact; all photos at full size are marked as exact",
    {{"package_bytes", "psnr"}, {"photos", "psnr"}, {"pixels", "psnr"}},
    jobs,
    true};

}  // namespace vantage::bench

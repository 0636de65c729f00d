// Measures the blending of photos: the mode, the number of photos, the sharpness, and the number of photos
// per pass.
#include <fmt/format.h>

#include "tests/bench/measure/pictures.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

constexpr struct {
    Blend blend;
    const char* name;
} modes[] = {{Blend::lumigraph, "lumigraph"}, {Blend::average, "average"}, {Blend::best, "best"}};

std::vector<PictureSetting> photo_counts(int most) {
    std::vector<PictureSetting> out;
    for (const auto& mode : modes)
        for (const int photos : {0, 1, 2, 4, 8, 16}) {
            if (photos >= most) continue;
            PictureSetting s{mode.name, photos ? fmt::format("{}", photos) : "all", !photos, false, {}};
            s.settings.blend = mode.blend;
            s.settings.photos = photos;
            s.chosen = photos == window_photos && mode.blend == Blend::lumigraph;
            out.push_back(s);
        }
    return out;
}

std::vector<PictureSetting> exponents(int) {
    std::vector<PictureSetting> out;
    const RenderSettings usual;
    for (const double e : {0.0, 1.0, 2.0, 4.0, 8.0, 16.0}) {
        PictureSetting s{"average, exponent", fmt::format("{:g}", e), false, e == usual.weights.exponent, {}};
        s.settings.blend = Blend::average;
        s.settings.weights.exponent = e;
        s.known["exponent"] = e;
        s.timed = e == usual.weights.exponent;
        out.push_back(s);
    }
    for (const double radians : {0.01, 0.02, 0.04, usual.weights.sharpness, 0.1, 0.2, 0.5}) {
        PictureSetting s{"lumigraph, sharpness",
                         fmt::format("{:g}", radians),
                         false,
                         radians == usual.weights.sharpness,
                         {}};
        s.settings.weights.sharpness = radians;
        s.known["sharpness"] = radians;
        s.timed = radians == usual.weights.sharpness;
        out.push_back(s);
    }
    PictureSetting transients{"lumigraph, sharpness", "transients", false, false, {}};
    transients.settings.transients = true;
    out.push_back(transients);
    return out;
}

std::vector<PictureSetting> passes(int) {
    std::vector<PictureSetting> out;
    for (const int n : {16, 8, 4, 2, 1}) {
        PictureSetting s{
            "photos per pass", fmt::format("{}", n), n == 16, n == RenderSettings{}.photos_per_pass, {}};
        s.settings.photos_per_pass = n;
        out.push_back(s);
    }
    return out;
}

Job pictures_job(const char* name, const BenchScene& scene, const Effort& effort,
                 const std::filesystem::path& folder, std::vector<PictureSetting> (*settings)(int photos)) {
    return {name, [=, &scene] {
                return measure_pictures(scene.package, scene, effort,
                                        settings(int(scene.views.front().photos.size())), folder,
                                        std::string("blending-") + name);
            }};
}

std::vector<Job> photo_jobs(const BenchScene& scene, const Effort& effort,
                            const std::filesystem::path& folder) {
    return {pictures_job("photos", scene, effort, folder, photo_counts)};
}
std::vector<Job> exponent_jobs(const BenchScene& scene, const Effort& effort,
                               const std::filesystem::path& folder) {
    return {pictures_job("exponents", scene, effort, folder, exponents)};
}
std::vector<Job> sum_jobs(const BenchScene& scene, const Effort& effort,
                          const std::filesystem::path& folder) {
    return {pictures_job("passes", scene, effort, folder, passes)};
}

}  // namespace

extern const Sweep blending_sweep, exponent_sweep, sums_sweep;
const Sweep blending_sweep{
    "blending",
    "Blending modes and number of photos",
    "More photos cost time in every frame. How many are enough, and which weighting is best?",
    "the held-out photo, or the ray-cast picture; also against the same mode with all photos",
    "exact by definition, because it is the picture blended from all photos",
    {{"frame_ms", "psnr"}, {"photos", "psnr"}, {"photos", "psnr_exact"}},
    photo_jobs};
const Sweep exponent_sweep{
    "exponent",
    "Preference for photos at small angles",
    "A single photo is sharp but shows its borders; many photos blur. Which setting is best?",
    "the held-out photo, or the ray-cast picture",
    "not applicable: no setting is exact",
    {{"sharpness", "psnr"}, {"exponent", "psnr"}, {"frame_ms", "psnr"}},
    exponent_jobs,
    true};
const Sweep sums_sweep{"sums",
                       "Photos per pass",
                       "Fewer, larger passes need less bandwidth. Do they change the picture?",
                       "all photos in one pass",
                       "at least 50 dB with any number of passes",
                       {{"frame_ms", "psnr_exact"}},
                       sum_jobs,
                       true};

}  // namespace vantage::bench

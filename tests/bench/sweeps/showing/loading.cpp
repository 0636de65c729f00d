// Compares the amounts of data loaded before the first picture: thumbnails only, coarser levels, or
// everything.
#include <fmt/format.h>

#include "base/gl/context.h"
#include "tests/bench/measure/exhibit.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

std::vector<PictureSetting> settings() {
    std::vector<PictureSetting> out;
    for (const int bias : {0, 1, 2, 3}) {
        PictureSetting s{
            "tiles", bias ? fmt::format("{} levels coarser", bias) : "full resolution", !bias, !bias, {}};
        s.settings.photos = window_photos;
        s.settings.lod_bias = bias;
        out.push_back(s);
    }
    PictureSetting s{"thumbnails", "thumbnails", false, false, {}};
    s.settings.photos = window_photos;
    s.settings.thumbnails = true;
    out.push_back(s);
    return out;
}

struct Opened {
    double ms = 0, bytes = 0;
};

/// Measures the time from opening the package to the first complete frame.
Opened open_and_show(const BenchScene& scene, const PictureSetting& s) {
    const gl::HeadlessContext context;
    Opened out;
    out.ms = milliseconds([&] {
        const PackageReader package(scene.package);
        Renderer renderer(package, ample_memory());
        settle(renderer, scene.views.front(), s);
        out.bytes = double(renderer.resources().store.streamed().bytes);
    });
    return out;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort,
                                 const std::filesystem::path& folder) {
    const std::vector<PictureSetting> all = settings();
    std::vector<Opened> opened(all.size());
    const std::vector<double> ms = medians_in_turn(all.size(), effort.repeats, [&](std::size_t i) {
        opened[i] = open_and_show(scene, all[i]);
        return opened[i].ms;
    });
    std::vector<Measurement> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        // Each setting has a new renderer, so that it does not show tiles that were loaded for another
        // setting.
        const PackageReader package(scene.package);
        const gl::HeadlessContext context;
        Renderer renderer(package, ample_memory());
        const std::vector<Picture> pictures = render_views(renderer, scene, all[i]);
        const PictureErrors e = picture_errors(scene.views, pictures);
        out.push_back({"", "", all[i].curve, all[i].setting, all[i].exact, all[i].chosen, {}, {}});
        out.back().values = {{"psnr", e.psnr},
                             {"ssim", e.ssim},
                             {"uncoloured", e.uncolored},
                             {"read_bytes", opened[i].bytes},
                             {"first_ms", ms[i]}};
        const Picture& truth = scene.views.front().truth;
        if (i == 0 || i + 1 == all.size())
            out.back().exhibits.push_back(keep_exhibit(
                folder, fmt::format("{}-loading-{}", scene.name, i), all[i].setting, pictures.front(),
                {truth.width / 3, truth.height / 3, std::min(360, truth.width / 2),
                 std::min(240, truth.height / 2)}));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    return {{"pictures", [=, &scene] { return measure(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep loading_sweep;
const Sweep loading_sweep{
    "loading",
    "Time to the first picture",
    "Thumbnails load immediately; tiles take longer. How good is the picture at each step?",
    "the held-out photo, or the ray-cast picture",
    "exact by definition, because it is the picture at full resolution",
    {{"first_ms", "psnr"}, {"read_bytes", "psnr"}},
    jobs};

}  // namespace vantage::bench

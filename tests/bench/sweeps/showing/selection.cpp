// Measures the selection of the photos to blend: the method and the hysteresis.
#include <fmt/format.h>

#include <algorithm>

#include "base/values/quantile.h"
#include "player/view/camera_path.h"
#include "tests/bench/measure/mean.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

constexpr struct {
    Choice choice;
    const char* name;
} choices[] = {{Choice::cover, "cover"}, {Choice::nearest, "nearest"}};

std::vector<PictureSetting> settings() {
    std::vector<PictureSetting> out{{"all", "all", true, false, {}}};
    for (const auto& c : choices)
        for (const int photos : {1, 2, 3, 4, 8}) {
            if (photos == 3 && c.choice != Choice::nearest) continue;
            PictureSetting s{c.name,
                             fmt::format("{}", photos),
                             false,
                             c.choice == Choice::cover && photos == window_photos,
                             {}};
            s.settings.choice = c.choice;
            s.settings.photos = photos;
            out.push_back(s);
        }
    return out;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort,
                                 const std::filesystem::path& folder) {
    return measure_pictures(scene.package, scene, effort, settings(), folder, "selection");
}

/// Measures the changes in the selection per frame along a path, and the cost of planning.
Measurement fly(const PlanScene& scene, const CameraPath& path, PlanSettings settings, const char* name,
                bool remembers, const TrueView& from) {
    std::vector<std::uint32_t> former;
    std::vector<double> ms, uncovered, counts;
    std::size_t changes = 0;
    for (const Navigation& n : path.frames) {
        const View view = view_of(n, from.view.intrinsics.width, from.view.intrinsics.height);
        Plan plan;
        ms.push_back(milliseconds([&] {
            plan = make_plan(scene, view, settings, from.photos,
                             {.previous = remembers ? former : std::vector<std::uint32_t>()});
        }));
        std::vector<std::uint32_t> now;
        for (const PlannedPhoto& p : plan.photos) now.push_back(p.photo);
        for (const std::uint32_t p : now)
            changes += n.eye != path.frames.front().eye && std::ranges::count(former, p) == 0;
        former = now;
        uncovered.push_back(100 * plan.uncovered);
        counts.push_back(double(now.size()));
    }
    Measurement m{"",
                  "",
                  std::string(name) + (remembers ? ", remembering" : ", forgetting"),
                  fmt::format("{}", settings.photos),
                  false,
                  false,
                  {},
                  {}};
    m.values = {{"changes", double(changes) / double(path.frames.size())},
                {"plan_ms", quantile(ms, 0.5)},
                {"uncovered", mean(uncovered)},
                {"photos", mean(counts)}};
    return m;
}

std::vector<Measurement> measure_path(const BenchScene& scene) {
    const PackageReader package(scene.package);
    const PlanScene plans = make_plan_scene(package);
    const auto photos = package.photos();
    const CameraPath path =
        scripted_path("orbit", stand_at(photos[photos.size() / 2], up_of(package.scene())), 90);
    std::vector<Measurement> out;
    for (const auto& c : choices)
        for (const int n : {1, 4, 8})
            for (const bool remembers : {true, false}) {
                PlanSettings settings;
                settings.choice = c.choice;
                settings.photos = n;
                settings.sharpness = RenderSettings{}.weights.sharpness;
                Measurement m = fly(plans, path, settings, c.name, remembers, scene.views.front());
                m.chosen = remembers && c.choice == Choice::cover && n == window_photos;
                out.push_back(std::move(m));
            }
    PlanSettings all;
    Measurement m = fly(plans, path, all, "all", false, scene.views.front());
    m.exact = true;
    m.setting = "all";
    m.curve = "all";
    out.push_back(std::move(m));
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    return {{"pictures", [=, &scene] { return measure(scene, effort, folder); }}};
}
std::vector<Job> path_jobs(const BenchScene& scene, const Effort&, const std::filesystem::path&) {
    return {{"orbit", [&scene] { return measure_path(scene); }}};
}

}  // namespace

extern const Sweep selection_sweep, hysteresis_sweep;
const Sweep selection_sweep{"selection",
                            "Which photos are blended",
                            "The nearest photos may not see everything in view; a set cover of photos does. "
                            "How much is left uncolored, and what does each method cost?",
                            "the held-out photo, or the ray-cast picture; visibility by ray casting",
                            "0 % uncolored, except at the borders of depth maps (0.2 %)",
                            {{"frame_ms", "psnr"}, {"photos", "uncoloured", true, true}, {"photos", "psnr"}},
                            jobs};
const Sweep hysteresis_sweep{
    "hysteresis",
    "Hysteresis in the choice of photos",
    "Photos that are selected only for a few frames cause flicker. How many photos change per frame on an "
    "orbit of 90 frames?",
    "all photos, so that nothing changes",
    "0 changes, 0 % uncovered",
    {{"plan_ms", "changes"}, {"photos", "changes"}, {"photos", "uncovered", true, true}},
    path_jobs};

}  // namespace vantage::bench

// Compares the presets in configs/ with other combinations of settings, by preparation time, bytes and frame
// time.
#include <fmt/format.h>

#include "base/values/quantile.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/prepared.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

namespace fs = std::filesystem;

struct Candidate {
    std::string curve, name;
    std::vector<std::string> options;
};

std::vector<Candidate> candidates(bool full) {
    std::vector<Candidate> out;
    for (const char* preset : {"preview", "default", "ci"})
        out.push_back({"presets", preset, {"--preset", preset}});
    for (const int size : full ? std::vector{0, 2048, 1024, 640} : std::vector{0, 1024})
        for (const char* distance : {"exact", "jfa^2"})
            for (const char* fragment : {"on", "off"}) {
                if (!full && (distance[0] != 'e' || (fragment[1] == 'f' && size))) continue;
                out.push_back({std::string("coordinates per ") + (fragment[1] == 'n' ? "fragment" : "vertex"),
                               fmt::format("{} {}", size ? fmt::format("{} px", size) : "full", distance),
                               {"--max-photo-size", std::to_string(size), "--border-distance", distance,
                                "--effect", std::string("per-fragment=") + fragment}});
            }
    return out;
}

/// Prepares all candidates in an interleaved order, so that changes in the machine's speed affect them
/// equally.
std::vector<PrepareCost> prepare_all(const BenchScene& scene, const std::vector<Candidate>& all,
                                     int repeats) {
    std::vector<std::vector<double>> seconds(all.size());
    std::vector<PrepareCost> costs(all.size());
    const fs::path file = scene.package.string() + ".candidate";
    for (int r = 0; r < repeats; ++r)
        for (std::size_t i = 0; i < all.size(); ++i) {
            const PrepareCost c = run_prepare(scene.folder, file, all[i].options);
            seconds[i].push_back(c.seconds);
            costs[i].memory_bytes = std::max(costs[i].memory_bytes, c.memory_bytes);
        }
    for (std::size_t i = 0; i < all.size(); ++i) costs[i].seconds = quantile(seconds[i], 0.5);
    fs::remove(file);
    return costs;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    const bool full = effort.name == "full";
    const std::vector<Candidate> all = candidates(full);
    const std::vector<PrepareCost> costs = prepare_all(scene, all, full ? effort.repeats : 1);
    std::vector<Measurement> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        PictureSetting s{all[i].curve, all[i].name, false, all[i].name == "default", {}};
        s.settings.photos = window_photos;
        out.push_back(
            measure_prepared(scene, effort, all[i].options, s, folder, fmt::format("presets-{}", i)));
        if (all[i].curve != "presets") out.back().exhibits.clear();
        out.back().values["prepare_s"] = costs[i].seconds;
        out.back().values["memory_bytes"] = costs[i].memory_bytes;
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    return {{"candidates", [=, &scene] { return measure(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep presets_sweep;
const Sweep presets_sweep{"presets",
                          "Presets compared with other settings",
                          "Which settings are on the Pareto front, and how far from it are the presets?",
                          "the held-out photo, or the ray-cast picture",
                          "not applicable: no setting is exact",
                          {{"prepare_s", "psnr"}, {"package_bytes", "psnr"}, {"frame_ms", "psnr"}},
                          jobs};

}  // namespace vantage::bench

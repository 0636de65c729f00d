// Measures the gain and the cost of the corrections that make photos agree before blending.
#include <array>

#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/prepared.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

namespace fs = std::filesystem;

struct Candidate {
    const char* name;
    std::vector<std::string> options;
};

const std::array<Candidate, 4>& candidates() {
    static const std::array<Candidate, 4> all{
        Candidate{"off", {"--refine", "off"}},
        Candidate{"colour", {"--refine", "color"}},
        Candidate{"full", {}},
        Candidate{"full, cameras always registered", {"--effect", "pose-refinement=on"}},
    };
    return all;
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    std::vector<Measurement> out;
    for (std::size_t i = 0; i < candidates().size(); ++i) {
        const Candidate& c = candidates()[i];
        PictureSetting s{
            "refine", c.name, i + 1 == candidates().size(), std::string_view(c.name) == "full", {}};
        out.push_back(measure_prepared(scene, effort, c.options, s, folder, "agreeing-" + std::to_string(i)));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    return {{"refine", [=, &scene] { return measure(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep agreeing_sweep;
const Sweep agreeing_sweep{
    "agreeing",
    "Making photos agree",
    "How much do color matching, camera pose refinement and transient masks gain, and how much do they cost?",
    "the held-out photo, or the ray-cast picture",
    "not applicable, because no setting is exact; the one marked as exact refines poses regardless of the "
    "evidence",
    {{"prepare_s", "psnr"}, {"prepare_s", "ssim"}},
    jobs};

}  // namespace vantage::bench

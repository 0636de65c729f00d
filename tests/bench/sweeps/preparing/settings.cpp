// Measures the effects of prepare's settings, varied one at a time.
#include "pipeline/run/settings.h"

#include <fmt/format.h>

#include "pipeline/prepare/prepare.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/prepared.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

namespace fs = std::filesystem;

struct Knob {
    const char* option;
    std::vector<std::string> values;
    std::string usual;
};

std::vector<Knob> knobs() {
    const PrepareSettings usual;
    const auto text = [](auto value) { return fmt::format("{:g}", double(value)); };
    return {{"border-width", {"16", "32", "64", "128"}, text(usual.border_width)},
            {"border-threshold", {"0.0025", "0.01", "0.04"}, text(usual.border_threshold)},
            {"thumbnail-size", {"128", "256", "512", "1024"}, text(usual.thumbnail)},
            {"compact", {"off", "on"}, "on"}};
}

/// For the thumbnail option, the picture is rendered from thumbnails alone; otherwise, it is the final
/// picture.
PictureSetting picture_setting(const Knob& knob, const std::string& value) {
    PictureSetting s{knob.option, value, false, value == knob.usual, {}};
    s.settings.photos = window_photos;
    s.timed = false;
    s.settings.thumbnails = std::string(knob.option) == "thumbnail-size";
    return s;
}

std::vector<std::string> options(const Knob& knob, const std::string& value) {
    const std::string name = knob.option;
    if (name == "compact") return {"--effect", name + "=" + value};
    return {"--" + name, value};
}

std::vector<Measurement> measure(const BenchScene& scene, const Effort& effort, const fs::path& folder,
                                 const Knob& knob) {
    std::vector<Measurement> out;
    for (const std::string& value : knob.values) {
        if (effort.name == "smoke" && value != knob.values.front() && value != knob.usual) continue;
        const PictureSetting s = picture_setting(knob, value);
        out.push_back(measure_prepared(scene, effort, options(knob, value), s, folder, "preparing"));
        out.back().exhibits.clear();
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const fs::path& folder) {
    std::vector<Job> out;
    for (const Knob& knob : knobs())
        out.push_back({knob.option, [=, &scene] { return measure(scene, effort, folder, knob); }});
    return out;
}

}  // namespace

extern const Sweep preparing_sweep;
const Sweep preparing_sweep{
    "preparing",
    "Settings of prepare, one at a time",
    "How do border and thumbnail settings and the form of tiles affect the picture and the package? "
    "(Thumbnails are judged by a picture rendered from thumbnails alone.)",
    "the held-out photo, or the ray-cast picture",
    "not applicable: no setting is exact",
    {{"prepare_s", "psnr"}, {"package_bytes", "psnr"}},
    jobs,
    true};

}  // namespace vantage::bench

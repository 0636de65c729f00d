// Compares stereo pictures whose photos are selected once for both eyes with those whose photos are selected
// for each eye.
#include <fmt/format.h>

#include "base/gl/context.h"
#include "player/view/stereo.h"
#include "tests/bench/measure/looked_at.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

struct PairSetting {
    int photos;  ///< 0: all
    bool together;
};

std::vector<PairSetting> pair_settings(int most) {
    std::vector<PairSetting> out;
    for (const bool together : {true, false})
        for (const int photos : {0, 1, 2, 4, 8})
            if (photos < most) out.push_back({photos, together});
    return out;
}

RenderSettings render_settings_of(const PairSetting& s) {
    RenderSettings out;
    out.photos = s.photos;
    out.loading = Loading::streamed;
    return out;
}

/// The views of a viewer whose left eye is at a reference view and whose right eye is next to it; both eyes
/// converge on the scene's center.
std::vector<View> eyes_at(const View& view, const PlanScene& scene) {
    const Eyes eyes{.share = 1.0 / 30};
    std::vector<View> out = eye_views(view, eyes, looked_at(view, scene));
    View& right = out[1];
    right.cam_from_origin.t.x() -= out[0].cam_from_origin.t.x() - view.cam_from_origin.t.x();
    right.intrinsics.cx += view.intrinsics.cx - out[0].intrinsics.cx;
    out[0] = view;
    return out;
}

/// Draws frames for two eyes in the same way as for a headset, with one sample per pixel.
class EyePairs {
  public:
    explicit EyePairs(const PackageReader& package)
        : both_(package, ample_memory()), left_(package, ample_memory()), right_(package, ample_memory()) {}

    void draw(const PairSetting& s, const TrueView& view) {
        now_ += 10;  // seconds, so that nothing is still fading in
        const RenderSettings settings = render_settings_of(s);
        const std::vector<View> eyes = eyes_at(view.view, both_.scene());
        if (s.together) {
            report_ = both_.prepare({eyes, settings, view.photos, {}, now_});
            for (const std::size_t eye : {0, 1}) both_.paint(eye, report_);
        } else {
            report_ = left_.draw(eyes[0], settings, view.photos, {}, now_);
            right_.draw(eyes[1], settings, view.photos, {}, now_);
        }
        glFinish();
    }
    /// Draws up to 1000 frames, until the left eye's picture has all its tiles.
    Picture left_picture(const PairSetting& s, const TrueView& view) {
        for (int n = 0; n < 1000; ++n) {
            draw(s, view);
            if (n > 4 && report_.tiles_missing == 0) break;
        }
        Picture out = picture_of(frame_size(view.view), [&](GLuint target) {
            (s.together ? both_ : left_).show(view.view, render_settings_of(s), {target});
        });
        out.report = report_;
        return out;
    }

  private:
    Renderer both_, left_, right_;
    FrameReport report_;
    double now_ = 0;
};

std::vector<Measurement> measure_pairs(const BenchScene& scene, const Effort& effort) {
    const PackageReader package(scene.package);
    const gl::HeadlessContext context;
    EyePairs pairs(package);
    const std::vector<PairSetting> settings = pair_settings(int(scene.views.front().photos.size()));
    std::vector<Measurement> out;
    for (const PairSetting& s : settings) {
        std::vector<Picture> pictures;
        double photos = 0;
        for (const TrueView& view : scene.views) {
            pictures.push_back(pairs.left_picture(s, view));
            photos += double(pictures.back().report.photos) / double(scene.views.size());
        }
        const PictureErrors e = picture_errors(scene.views, pictures);
        out.push_back({"",
                       "",
                       s.together ? "for both eyes" : "for each eye",
                       s.photos ? fmt::format("{}", s.photos) : "all",
                       s.photos == 0 && !s.together,
                       s.photos == window_photos && s.together,
                       {{"psnr", e.psnr}, {"ssim", e.ssim}, {"worst", e.worst}, {"photos", photos}},
                       {}});
    }
    const auto time = [&](std::size_t i) {
        pairs.draw(settings[i], scene.views.front());
        return milliseconds([&] { pairs.draw(settings[i], scene.views.front()); });
    };
    const std::vector<double> ms = medians_in_turn(settings.size(), effort.repeats, time);
    for (std::size_t i = 0; i < settings.size(); ++i) out[i].values["frame_ms"] = ms[i];
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path&) {
    return {{"pairs", [&] { return measure_pairs(scene, effort); }}};
}

}  // namespace

extern const Sweep two_eyes_sweep;
const Sweep two_eyes_sweep{
    "two_eyes",
    "Photos for two eyes",
    "If photos and tiles are selected only once, they serve both eyes. Is each eye's picture still as good?",
    "the held-out photo, or the ray-cast picture, for the left eye",
    "exact by definition, because it blends all photos, planned separately for each eye",
    {{"frame_ms", "psnr"}, {"photos", "psnr"}},
    jobs};

}  // namespace vantage::bench

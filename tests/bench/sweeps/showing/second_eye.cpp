// Measures the cost of the second eye for different ways of drawing the bare surface for both eyes.
#include <deque>
#include <span>
#include <vector>

#include "base/gl/context.h"
#include "player/measure/bench/flight.h"
#include "player/render/renderer.h"
#include "player/view/camera_path.h"
#include "player/view/stereo.h"
#include "tests/bench/measure/looked_at.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

constexpr int rounds = 10;  ///< rounds per repeat; several, because the differences are small

struct EyesSetting {
    const char* name;
    StereoMode mode;
    EyeSurfaces surfaces;
};
constexpr EyesSetting eyes_settings[] = {
    {"one eye", StereoMode::off, EyeSurfaces::automatic},
    {"two eyes, in turn", StereoMode::side_by_side, EyeSurfaces::in_turn},
    {"two eyes, overlapped", StereoMode::side_by_side, EyeSurfaces::overlapped},
    {"two eyes, at once", StereoMode::side_by_side, EyeSurfaces::at_once}};

/// Draws the frames of a path with as many photos as a window blends. All tiles that complete
/// pictures need are resident.
class EyesFlight {
  public:
    EyesFlight(const PackageReader& package, const EyesSetting& setting, std::span<const View> path,
               std::span<const std::uint32_t> photos)
        : renderer_(package, ample_memory()),
          photos_(photos.begin(), photos.end()),
          target_(make_flight_target(frame_size(path.front()))) {
        settings_.photos = window_photos;
        settings_.fill_holes = true;
        renderer_.resources().trials.eye_surfaces = setting.surfaces;
        for (const View& view : path)
            frames_.push_back(views_of({.mode = setting.mode, .eyes = {.share = 1.0 / 30}}, view,
                                       looked_at(view, renderer_.scene())));
        for (const auto& eyes : frames_) draw(eyes);  // complete, which makes the tiles resident
        settings_.loading = Loading::repeatable;
        for (int n = 0; n < 5; ++n) draw(frames_.front());
        settings_.loading = Loading::streamed;
    }
    void draw_next() { draw(frames_[next_++ % frames_.size()]); }

  private:
    void draw(std::span<const View> eyes) {
        now_ += frame_seconds;
        FrameReport report = renderer_.prepare({eyes, settings_, photos_, {}, now_});
        for (std::size_t eye = 0; eye < eyes.size(); ++eye) {
            renderer_.paint(eye, report);
            renderer_.show(eyes[eye], settings_, {target_.framebuffer.id(), false, eye});
        }
        glFinish();
    }

    Renderer renderer_;
    std::vector<std::uint32_t> photos_;
    FlightTarget target_;
    RenderSettings settings_;
    std::vector<std::vector<View>> frames_;
    std::size_t next_ = 0;
    double now_ = 0;
};

std::vector<Measurement> measure_eyes(const BenchScene& scene, const Effort& effort, const char* curve,
                                      std::span<const View> path) {
    const PackageReader package(scene.package);
    const gl::HeadlessContext context;
    std::deque<EyesFlight> all;
    for (const EyesSetting& s : eyes_settings) all.emplace_back(package, s, path, scene.views.front().photos);
    const auto time = [&](std::size_t i) { return milliseconds([&] { all[i].draw_next(); }); };
    const std::vector<double> ms = medians_in_turn(all.size(), rounds * effort.repeats, time);
    const EyeSurfaces chosen = gl::current_device().software ? EyeSurfaces::overlapped : EyeSurfaces::at_once;
    std::vector<Measurement> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const EyesSetting& s = eyes_settings[i];
        out.push_back({"", "", curve, s.name, s.mode == StereoMode::off, s.surfaces == chosen, {}, {}});
        out.back().values["frame_ms"] = ms[i];
    }
    return out;
}

/// The first eighth of a circle, at 30 frames per second.
std::vector<View> orbit(const BenchScene& scene, const Effort& effort) {
    const PackageReader package(scene.package);
    const TrueView& view = scene.views.front();
    const int frames = rounds * effort.repeats;
    const CameraPath path = scripted_path("orbit", home_of(package, view.photos.front()), 8 * frames);
    std::vector<View> out;
    for (int i = 0; i < frames; ++i)
        out.push_back(
            view_of(path.frames[std::size_t(i)], view.view.intrinsics.width, view.view.intrinsics.height));
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path&) {
    return {
        {"rest",
         [&] {
             return measure_eyes(scene, effort, "eyes of a frame at rest", {&scene.views.front().view, 1});
         }},
        {"motion",
         [&] { return measure_eyes(scene, effort, "eyes of a frame in motion", orbit(scene, effort)); }}};
}

}  // namespace

extern const Sweep second_eye_sweep;
const Sweep second_eye_sweep{"second_eye",
                             "The second eye",
                             "How much does the second eye cost per frame?",
                             "one eye",
                             "not applicable: the pictures are identical, bit for bit",
                             {},
                             jobs,
                             true};

}  // namespace vantage::bench

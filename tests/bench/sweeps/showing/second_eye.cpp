// What the second eye costs, by the way in which the bare surface is drawn for both.
#include <array>
#include <deque>
#include <span>
#include <vector>

#include "gl/context.h"
#include "player/camera/camera_path.h"
#include "player/camera/stereo.h"
#include "player/render/renderer.h"
#include "tests/bench/measure/pictures.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

constexpr int rounds = 10;  ///< of each repeat: the differences are small

struct EyesSetting {
    const char* name;
    std::size_t eyes;
    EyeSurfaces surfaces;
};
constexpr EyesSetting eyes_settings[] = {{"one eye", 1, EyeSurfaces::automatic},
                                         {"two eyes, in turn", 2, EyeSurfaces::in_turn},
                                         {"two eyes, overlapped", 2, EyeSurfaces::overlapped},
                                         {"two eyes, at once", 2, EyeSurfaces::at_once}};

/// Draws the frames of a path with the photos of a window. The tiles of complete pictures are resident.
class EyesFlight {
  public:
    EyesFlight(const PackageReader& package, const EyesSetting& setting, std::span<const View> path,
               std::span<const std::uint32_t> photos)
        : renderer_(package, ample_memory()),
          photos_(photos.begin(), photos.end()),
          size_(frame_size(path.front())),
          color_(gl::make_texture_2d("bench", GL_RGBA8, size_.width, size_.height)),
          target_(gl::make_framebuffer("bench", std::array{color_.id()}, 0)) {
        settings_.photos = window_photos;
        settings_.fill_holes = true;
        settings_.eye_surfaces = setting.surfaces;
        for (const View& view : path) {
            const double distance = depth_in(view, Eigen::Vector3d::Zero());
            const double convergence = distance > 0 ? distance : renderer_.scene().size;
            const auto both = eye_views(view, {.share = 1.0 / 30}, convergence);
            frames_.emplace_back(both.begin(), both.begin() + std::ptrdiff_t(setting.eyes));
        }
        for (const auto& eyes : frames_) draw(eyes);  // complete, which makes the tiles resident
        settings_.complete = false;
        settings_.wait_for_tiles = true;
        for (int n = 0; n < 5; ++n) draw(frames_.front());
        settings_.wait_for_tiles = false;
    }
    void draw_next() { draw(frames_[next_++ % frames_.size()]); }

  private:
    void draw(std::span<const View> eyes) {
        now_ += 1.0 / 30;
        FrameReport report = renderer_.prepare(eyes, settings_, photos_, {}, now_);
        for (std::size_t eye = 0; eye < eyes.size(); ++eye) {
            renderer_.paint(eye, report);
            renderer_.show(eyes[eye], settings_, target_.id(), false, eye);
        }
        glFinish();
    }

    Renderer renderer_;
    std::vector<std::uint32_t> photos_;
    FrameSize size_;
    gl::Texture color_;
    gl::Framebuffer target_;
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
        out.push_back({"", "", curve, s.name, s.eyes == 1, s.surfaces == chosen, {}, {}});
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
                             "What does the second eye cost per frame?",
                             "one eye",
                             "not applicable: the pictures are the same to the bit",
                             {},
                             jobs,
                             true};

}  // namespace vantage::bench
